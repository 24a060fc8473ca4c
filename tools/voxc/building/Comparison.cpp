// A traversal over two sources at once, in Morton order, that leaves out what is empty in both.
#include "building/Comparison.h"

#include <algorithm>
#include <array>
#include <bit>

namespace voxc::tool {

namespace {

constexpr int kLog2Block = 3; // The largest cube that a source reads at once.
constexpr std::size_t kBlockVoxels = std::size_t{1} << (3 * kLog2Block);

int log2Bound(Int3 extent) {
  const auto longest = static_cast<std::uint32_t>(std::max({extent.x, extent.y, extent.z, 1 << kLog2Block}));
  return std::bit_width(longest - 1);
}

class Comparer {
public:
  Comparer(VoxelSource &volume, VoxelSource &input, const Progress &progress, const VoxelRange &range)
      : volume_(volume), input_(input), progress_(progress), range_(range),
        log2Side_(std::max(log2Bound(volume.extent()), log2Bound(input.extent()))) {}

  Expected<VoxelDifferences> run() {
    VOXC_TRY(descend({{}, log2Side_}));
    return differences_;
  }

private:
  Expected<void> descend(const Cube &cube) {
    if (progress_.stopped())
      return Error::interrupted();
    if (isOutOfRange(cube) || (volume_.empty(cube) && input_.empty(cube)))
      return {};
    if (cube.log2Side == kLog2Block)
      return compareBlock(cube);
    const int childLog2Side = cube.log2Side - 1;
    for (std::uint64_t child = 0; child < 8; ++child)
      if (auto compared = descend({cube.low + mortonCell(child) * (1 << childLog2Side), childLog2Side});
          !compared)
        return compared;
    return {};
  }

  bool isOutOfRange(const Cube &cube) const {
    const std::uint64_t first = mortonCode(cube.low);
    return first >= range_.end || first + (std::uint64_t{1} << 3 * cube.log2Side) <= range_.begin;
  }

  Expected<void> compareBlock(const Cube &cube) {
    VOXC_TRY(volume_.read(cube, volumeWords_.data()));
    VOXC_TRY(input_.read(cube, inputWords_.data()));
    for (std::size_t i = 0; i < kBlockVoxels; ++i)
      compareVoxel(cube.low + mortonCell(i), volumeWords_[i], inputWords_[i]);
    progress_.at("comparing", double(mortonCode(cube.low)) / double(std::uint64_t{1} << (3 * log2Side_)));
    return {};
  }

  void compareVoxel(Int3 voxel, std::uint32_t volumeWord, std::uint32_t inputWord) {
    if (volumeWord == inputWord) {
      differences_.equal += volumeWord != 0;
      return;
    }
    if (!differences_.first)
      differences_.first = voxel;
    ++(volumeWord == 0 ? differences_.missing : inputWord == 0 ? differences_.surplus : differences_.changed);
  }

  VoxelSource &volume_;
  VoxelSource &input_;
  const Progress &progress_;
  VoxelRange range_;
  int log2Side_;
  VoxelDifferences differences_;
  std::array<std::uint32_t, kBlockVoxels> volumeWords_;
  std::array<std::uint32_t, kBlockVoxels> inputWords_;
};

} // namespace

void VoxelDifferences::add(const VoxelDifferences &other) {
  equal += other.equal;
  missing += other.missing;
  surplus += other.surplus;
  changed += other.changed;
  if (!first)
    first = other.first;
}

Expected<VoxelDifferences> compareVoxels(VoxelSource &volume, VoxelSource &input, const Progress &progress,
                                         const VoxelRange &range) {
  return Comparer(volume, input, progress, range).run();
}

} // namespace voxc::tool
