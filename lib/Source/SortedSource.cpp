// A list of voxels in Morton order as a source.
#include "Source/ChunkBricks.h"
#include "Source/ChunkedSource.h"
#include "Source/CubeTools.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace voxc {

namespace {

using SortedVoxels = std::shared_ptr<const std::vector<CodedVoxel>>;

class SortedLists final : public ChunkLists {
public:
  explicit SortedLists(SortedVoxels voxels) : voxels_(std::move(voxels)) {}

  bool empty(const Cube &cube) override {
    const std::uint64_t begin = mortonCode(cube.low);
    const std::size_t first = seek(begin);
    return first == voxels_->size() || (*voxels_)[first].code - begin >= cellCount(cube.log2Side);
  }

  Expected<std::span<const CodedVoxel>> voxels(Int3 chunk) override {
    const std::uint64_t begin = mortonCode(chunk) << 3 * ChunkBricks::kLog2Chunk;
    const std::size_t first = seek(begin);
    const std::size_t end = seek(begin + cellCount(ChunkBricks::kLog2Chunk));
    cursor_ = first;
    return std::span(*voxels_).subspan(first, end - first);
  }

  std::unique_ptr<ChunkLists> view() const override { return std::make_unique<SortedLists>(voxels_); }

private:
  /// Index of the first voxel at or behind `code`. Askers move forward in small steps, so the search gallops
  /// from where the last one ended.
  std::size_t seek(std::uint64_t code) {
    const std::vector<CodedVoxel> &voxels = *voxels_;
    std::size_t low = cursor_ < voxels.size() && voxels[cursor_].code <= code ? cursor_ : 0;
    std::size_t step = 1;
    while (low + step < voxels.size() && voxels[low + step].code < code) {
      low += step;
      step *= 2;
    }
    const auto end = voxels.begin() + static_cast<std::ptrdiff_t>(std::min(low + step, voxels.size()));
    const auto found = std::lower_bound(voxels.begin() + static_cast<std::ptrdiff_t>(low), end, code,
                                        [](const CodedVoxel &v, std::uint64_t c) { return v.code < c; });
    return cursor_ = static_cast<std::size_t>(found - voxels.begin());
  }

  SortedVoxels voxels_;
  std::size_t cursor_ = 0;
};

} // namespace

std::unique_ptr<VoxelSource> makeSortedSource(Int3 extent, std::vector<CodedVoxel> voxels,
                                              Transform voxelToModel) {
  auto shared = std::make_shared<const std::vector<CodedVoxel>>(std::move(voxels));
  return makeChunkedSource(extent, std::make_unique<SortedLists>(std::move(shared)), voxelToModel);
}

} // namespace voxc
