// A source made of a function of the coordinates.
#include "voxc/Source/VoxelSource.h"

#include "Source/CubeTools.h"

#include <utility>

namespace voxc {

namespace {

class FunctionSource final : public VoxelSource {
public:
  FunctionSource(Int3 extent, std::function<std::uint32_t(Int3)> voxel,
                 std::function<bool(const Cube &)> empty)
      : extent_(extent), voxel_(std::move(voxel)), empty_(std::move(empty)) {}

  Int3 extent() const override { return extent_; }

  std::unique_ptr<VoxelSource> view() const override {
    return std::make_unique<FunctionSource>(extent_, voxel_, empty_);
  }

  bool empty(const Cube &cube) override { return isOutside(cube, extent_) || (empty_ && empty_(cube)); }

  Expected<void> read(const Cube &cube, std::uint32_t *words) override {
    forEachCell(cube, [&](std::uint64_t index, Int3 cell) {
      words[index] = contains(extent_, cell) ? voxel_(cell) : 0;
    });
    return {};
  }

private:
  Int3 extent_;
  std::function<std::uint32_t(Int3)> voxel_;
  std::function<bool(const Cube &)> empty_;
};

} // namespace

std::unique_ptr<VoxelSource> makeFunctionSource(Int3 extent, std::function<std::uint32_t(Int3)> voxel,
                                                std::function<bool(const Cube &)> empty) {
  return std::make_unique<FunctionSource>(extent, std::move(voxel), std::move(empty));
}

} // namespace voxc
