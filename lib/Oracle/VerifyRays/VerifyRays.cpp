// The mixture of rays on which kernels are verified.
#include "voxc/Oracle/VerifyRays.h"

#include "RandomSource.h"
#include "RayKinds.h"

#include <algorithm>

namespace voxc {
namespace {

struct Share {
  unsigned percent;
  Ray (*make)(oracle::RandomSource &random, const RayTarget &target);
};

constexpr Share kShares[] = {
    {30, oracle::cameraRay},  {20, oracle::outsideRay}, {20, oracle::insideRay},   {8, oracle::axisCentreRay},
    {6, oracle::axisFaceRay}, {4, oracle::axisEdgeRay}, {12, oracle::diagonalRay},
};

/// Together they are all rays.
constexpr bool areWhole(std::span<const Share> shares) {
  unsigned sum = 0;
  for (const Share &share : shares)
    sum += share.percent;
  return sum == 100;
}
static_assert(areWhole(kShares));

/// The share that holds a percent, counted from 0.
const Share &holderOf(unsigned percent) {
  const Share *share = kShares;
  for (; percent >= share->percent; ++share)
    percent -= share->percent;
  return *share;
}

} // namespace

std::vector<Ray> verifyRays(const RayTarget &target, std::size_t count, std::uint64_t seed) {
  oracle::RandomSource random(seed);
  std::vector<Ray> rays(count);
  std::ranges::generate(rays, [&] {
    const auto percent = static_cast<unsigned>(random.integer(0, 99));
    return holderOf(percent).make(random, target);
  });
  return rays;
}

} // namespace voxc
