// Reading bricks of a source.
#include "SourceHost.h"

#include "Source/BrickBits.h"

#include <algorithm>
#include <bit>

namespace voxc {
namespace {

constexpr unsigned kCallsBetweenReports = 256;

} // namespace

MortonProgress::MortonProgress(Int3 extent, const Progress &progress) : progress_(progress) {
  const auto longest = static_cast<std::uint32_t>(std::max({extent.x, extent.y, extent.z, 1}));
  totalCodes_ = std::uint64_t{1} << (3 * std::bit_width(longest - 1));
}

bool MortonProgress::at(Int3 low, std::uint64_t voxels) {
  if (untilReport_-- != 0)
    return true;
  untilReport_ = kCallsBetweenReports;
  progress_.at("build", static_cast<double>(mortonCode(low)) / static_cast<double>(totalCodes_), voxels);
  return !progress_.stopped();
}

void SourceHost::prove(Int3 low, const std::uint32_t *voxels) {
  for (unsigned i = 0; i < 512; ++i)
    if (voxels[i] != 0)
      if (auto problem = proof_.prove(low + mortonCell(i), voxels[i]))
        return store().fail(std::move(*problem));
}

void SourceHost::readBrick(Int3 low, construct::Brick &brick) {
  std::uint32_t *const voxels = brick.voxels;
  if (auto done = source_.read({low, construct::kLog2Brick}, voxels); !done) {
    brick = {};
    return store().fail(done.error());
  }
  if (proof_.isNeeded())
    prove(low, voxels);
  if (!proof_.keepsWords())
    std::transform(voxels, voxels + 512, voxels, [this](std::uint32_t word) { return proof_.kept(word); });
  std::ranges::copy(bitsOf(voxels), brick.filled);
  for (const std::uint64_t bits : brick.filled)
    voxels_ += static_cast<std::uint64_t>(std::popcount(bits));
  if (!progress_.at(low, voxels_))
    store().fail(Error::interrupted());
}

} // namespace voxc
