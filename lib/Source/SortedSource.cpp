// A list of voxels in Morton order: what meshes and points become.
#include "voxc/Source/Sources.h"

#include "Source/CubeTools.h"

#include <algorithm>
#include <utility>

namespace voxc {

namespace {

class SortedSource final : public VoxelSource {
public:
  SortedSource(Int3 extent, std::vector<CodedVoxel> voxels, Transform voxelToModel)
      : extent_(extent), voxels_(std::move(voxels)), voxelToModel_(voxelToModel) {}

  Int3 extent() const override { return extent_; }
  Transform voxelToModel() const override { return voxelToModel_; }

  bool empty(const Cube &cube) override {
    if (isOutside(cube, extent_))
      return true;
    const std::uint64_t begin = mortonCode(cube.low);
    const std::size_t first = seek(begin);
    return first == voxels_.size() || voxels_[first].code - begin >= cellCount(cube.log2Side);
  }

  void read(const Cube &cube, std::uint32_t *words) override {
    const std::uint64_t count = cellCount(cube.log2Side);
    std::fill_n(words, count, 0u);
    if (isOutside(cube, extent_))
      return;
    const std::uint64_t begin = mortonCode(cube.low);
    for (std::size_t i = seek(begin); i < voxels_.size() && voxels_[i].code - begin < count; ++i)
      words[voxels_[i].code - begin] = voxels_[i].word;
  }

private:
  /// Index of the first voxel at or behind `code`. Askers move forward in small steps, so the search gallops
  /// from where the last one ended.
  std::size_t seek(std::uint64_t code) {
    std::size_t low = cursor_ < voxels_.size() && voxels_[cursor_].code <= code ? cursor_ : 0;
    std::size_t step = 1;
    while (low + step < voxels_.size() && voxels_[low + step].code < code) {
      low += step;
      step *= 2;
    }
    const auto end = voxels_.begin() + static_cast<std::ptrdiff_t>(std::min(low + step, voxels_.size()));
    const auto found = std::lower_bound(voxels_.begin() + static_cast<std::ptrdiff_t>(low), end, code,
                                        [](const CodedVoxel &v, std::uint64_t c) { return v.code < c; });
    return cursor_ = static_cast<std::size_t>(found - voxels_.begin());
  }

  Int3 extent_;
  std::vector<CodedVoxel> voxels_;
  Transform voxelToModel_;
  std::size_t cursor_ = 0;
};

} // namespace

std::unique_ptr<VoxelSource> makeSortedSource(Int3 extent, std::vector<CodedVoxel> voxels,
                                              Transform voxelToModel) {
  return std::make_unique<SortedSource>(extent, std::move(voxels), voxelToModel);
}

} // namespace voxc
