// Bins as lists of chunks: a bin is a chunk, or in a vast extent many, into which it is sorted when it is
// asked for.
#include "Source/BinnedVoxels.h"

#include "Source/ChunkBricks.h"
#include "Source/ChunkedSource.h"
#include "Source/CubeTools.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace voxc {

namespace {

using Bins = ChunkBins<CodedVoxel>;

class BinLists final : public ChunkLists {
public:
  BinLists(std::shared_ptr<const Bins> bins, std::shared_ptr<WorkingMemory> memory)
      : bins_(std::move(bins)), memory_(std::move(memory)), sorted_(memory_) {}

  bool empty(const Cube &cube) override {
    if (cube.log2Side >= bins_->log2Chunk())
      return bins_->empty(cube);
    const auto voxels = sortedVoxels(cube);
    return voxels && voxels->empty();
  }

  Expected<std::span<const CodedVoxel>> voxels(Int3 chunk) override {
    memory_->relieve();
    if (bins_->log2Chunk() == ChunkBricks::kLog2Chunk)
      return bins_->at(chunk);
    return sortedVoxels({chunk * (1 << ChunkBricks::kLog2Chunk), ChunkBricks::kLog2Chunk});
  }

  std::unique_ptr<ChunkLists> view() const override { return std::make_unique<BinLists>(bins_, memory_); }

private:
  /// The voxels of a cube that is smaller than a bin.
  Expected<std::span<const CodedVoxel>> sortedVoxels(const Cube &cube) {
    VOXC_TRY(sort(cube.low >> bins_->log2Chunk()));
    const std::span<const CodedVoxel> all = std::as_const(sorted_).span();
    const std::uint64_t begin = mortonCode(cube.low);
    const auto before = [](const CodedVoxel &voxel, std::uint64_t code) { return voxel.code < code; };
    const auto first = std::lower_bound(all.begin(), all.end(), begin, before);
    const auto last = std::lower_bound(first, all.end(), begin + cellCount(cube.log2Side), before);
    return std::span<const CodedVoxel>(first, last);
  }

  Expected<void> sort(Int3 bin) {
    if (bin == bin_)
      return {};
    VOXC_TRY(sorted_.resize(0));
    VOXC_TRY(sorted_.append(bins_->at(bin)));
    std::ranges::sort(sorted_.span(), [](const CodedVoxel &a, const CodedVoxel &b) {
      return a.code != b.code ? a.code < b.code : a.order < b.order;
    });
    bin_ = bin;
    return {};
  }

  std::shared_ptr<const Bins> bins_;
  std::shared_ptr<WorkingMemory> memory_;
  ScratchArray<CodedVoxel> sorted_; ///< The voxels of `bin_`.
  Int3 bin_{-1, -1, -1};
};

} // namespace

Expected<BinnedVoxels> BinnedVoxels::create(Int3 extent, const std::shared_ptr<WorkingMemory> &memory) {
  auto bins = VOXC_TRY(Bins::create(extent, Bins::log2ChunkFor(extent, ChunkBricks::kLog2Chunk), memory));
  return BinnedVoxels(extent, std::move(bins), memory);
}

Expected<void> BinnedVoxels::allocate() {
  if (counted_ > std::numeric_limits<std::uint32_t>::max())
    return Error::input("an input of " + std::to_string(counted_) +
                        " voxels cannot be sorted; it may have 2^32 - 1 of them");
  return bins_.allocate();
}

std::unique_ptr<VoxelSource> BinnedVoxels::finish(const Transform &voxelToModel) && {
  auto bins = std::make_shared<const Bins>(std::move(bins_));
  return makeChunkedSource(extent_, std::make_unique<BinLists>(std::move(bins), memory_), voxelToModel);
}

} // namespace voxc
