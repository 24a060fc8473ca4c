// Clipping a source to an extent.
#include "Source/ClippedSource.h"

#include "Source/CubeTools.h"

#include <algorithm>
#include <utility>

namespace voxc {

namespace {

class ClippedSource final : public VoxelSource {
public:
  ClippedSource(std::unique_ptr<VoxelSource> source, Int3 extent) : source_(std::move(source)) {
    for (int axis = 0; axis < 3; ++axis)
      extent_[axis] = std::min(extent[axis], source_->extent()[axis]);
  }

  Int3 extent() const override { return extent_; }
  Transform voxelToModel() const override { return source_->voxelToModel(); }
  int log2Chunk() const override { return source_->log2Chunk(); }
  double readSeconds() const override { return source_->readSeconds(); }

  std::unique_ptr<VoxelSource> view() const override {
    auto view = source_->view();
    return view ? clip(std::move(view), extent_) : nullptr;
  }

  bool empty(const Cube &cube) override { return isOutside(cube, extent_) || source_->empty(cube); }

  Expected<void> read(const Cube &cube, std::uint32_t *words) override {
    VOXC_TRY(source_->read(cube, words));
    forEachCell(cube, [&](std::uint64_t index, Int3 cell) {
      if (!contains(extent_, cell))
        words[index] = 0;
    });
    return {};
  }

private:
  std::unique_ptr<VoxelSource> source_;
  Int3 extent_;
};

} // namespace

std::unique_ptr<VoxelSource> clip(std::unique_ptr<VoxelSource> source, Int3 extent) {
  return std::make_unique<ClippedSource>(std::move(source), extent);
}

} // namespace voxc
