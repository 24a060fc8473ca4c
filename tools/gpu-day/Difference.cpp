// Comparing hits.
#include "Difference.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace voxc::gpu {
namespace {

/// Float32 numbers from one to the other, both at 0 or above.
std::uint64_t ulpsBetween(float a, float b) {
  const auto low = std::bit_cast<std::uint32_t>(std::min(a, b));
  return std::bit_cast<std::uint32_t>(std::max(a, b)) - low;
}

} // namespace

tool::Json Difference::toJson() const {
  return {{"missed", missed}, {"ghost", ghost}, {"wrong", wrong}, {"colour", colour}, {"max_ulp_dt", maxUlp}};
}

Difference differenceOf(std::span<const Hit> hits, std::span<const Hit> exact) {
  Difference all;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const Hit &hit = hits[i], &right = exact[i];
    if (std::memcmp(&hit, &right, offsetof(Hit, steps)) == 0)
      continue;
    if (hit.isHit() != right.isHit())
      ++(right.isHit() ? all.missed : all.ghost);
    else if (!std::ranges::equal(hit.voxel, right.voxel))
      ++all.wrong;
    else {
      all.colour += hit.rgba != right.rgba;
      all.maxUlp = std::max(all.maxUlp, ulpsBetween(hit.t, right.t));
    }
  }
  return all;
}

} // namespace voxc::gpu
