// Cropping: the box of all voxels is found first, then chunks of the box are put together from the cubes of
// the source that they overlap.
#include "voxc/Source/Crop.h"

#include "Source/ChunkBricks.h"
#include "Source/ChunkedSource.h"
#include "Source/ClippedSource.h"
#include "Source/CubeTools.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace voxc {

namespace {

constexpr int kLog2Chunk = ChunkBricks::kLog2Chunk;

/// Cells from `low` up to below `high`.
struct Box {
  Int3 low;
  Int3 high;

  bool overlaps(const Cube &cube) const {
    bool does = true;
    for (int axis = 0; axis < 3; ++axis)
      does = does && cube.low[axis] < high[axis] && cube.low[axis] + cube.side() > low[axis];
    return does;
  }
  bool holds(const Cube &cube) const {
    bool does = true;
    for (int axis = 0; axis < 3; ++axis)
      does = does && cube.low[axis] >= low[axis] && cube.low[axis] + cube.side() <= high[axis];
    return does;
  }
  bool holds(Int3 cell) const { return holds(Cube{cell, 0}); }
};

/// Calls `visit(voxel, word)` for the voxels of a cube but those in smaller cubes that `skips` tells to leave
/// out. Errors: those of `skips` and of the source.
template <typename Skips, typename Visit>
Expected<void> forEachVoxel(VoxelSource &source, const Cube &cube, Skips &skips, Visit &visit) {
  const auto isSkipped = VOXC_TRY(skips(cube));
  if (isSkipped || source.empty(cube))
    return {};
  if (cube.log2Side > ChunkBricks::kLog2Brick) {
    const int half = cube.log2Side - 1;
    for (unsigned octant = 0; octant < 8; ++octant)
      if (auto visited =
              forEachVoxel(source, {cube.low + mortonCell(octant) * (1 << half), half}, skips, visit);
          !visited)
        return visited;
    return {};
  }
  std::array<std::uint32_t, 512> words;
  VOXC_TRY(source.read(cube, words.data()));
  forEachCell(cube, [&](std::uint64_t index, Int3 cell) {
    if (words[index] != 0)
      visit(cell, words[index]);
  });
  return {};
}

Cube cubeAround(Int3 extent) {
  Cube cube{{}, ChunkBricks::kLog2Brick};
  while (cube.side() < std::max({extent.x, extent.y, extent.z}))
    ++cube.log2Side;
  return cube;
}

/// The smallest box around all voxels; one cell if there is none. What lies in the box of those that came
/// before is not read.
Expected<Box> boxOf(VoxelSource &source, const Progress &progress) {
  const Cube all = cubeAround(source.extent());
  Box box{source.extent(), {}};
  const auto skips = [&](const Cube &cube) -> Expected<bool> {
    if (cube.log2Side == kLog2Chunk) {
      progress.at("crop",
                  static_cast<double>(mortonCode(cube.low)) / static_cast<double>(cellCount(all.log2Side)));
      VOXC_TRY(progress.check());
    }
    return box.holds(cube);
  };
  const auto add = [&](Int3 cell, std::uint32_t) {
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], cell[axis]);
      box.high[axis] = std::max(box.high[axis], cell[axis] + 1);
    }
  };
  VOXC_TRY(forEachVoxel(source, all, skips, add));
  return box.high.x == 0 ? Box{{}, {1, 1, 1}} : box;
}

/// The chunks of a box of a source.
class MovedLists final : public ChunkLists {
public:
  MovedLists(std::unique_ptr<VoxelSource> source, const Box &box) : source_(std::move(source)), box_(box) {}

  bool empty(const Cube &cube) override {
    bool isEmpty = true;
    for (const Cube &part : overlapped(cube))
      isEmpty = isEmpty && source_->empty(part);
    return isEmpty;
  }

  Expected<std::span<const CodedVoxel>> voxels(Int3 chunk) override {
    const Cube cube{chunk * (1 << kLog2Chunk), kLog2Chunk};
    const Box within = boxIn(cube);
    voxels_.clear();
    const auto skips = [&](const Cube &part) -> Expected<bool> { return !within.overlaps(part); };
    const auto add = [&](Int3 cell, std::uint32_t word) {
      if (within.holds(cell))
        voxels_.push_back({mortonCode(cell - box_.low), word});
    };
    for (const Cube &part : overlapped(cube))
      VOXC_TRY(forEachVoxel(*source_, part, skips, add));
    return std::span<const CodedVoxel>(voxels_);
  }

  std::unique_ptr<ChunkLists> view() const override {
    auto view = source_->view();
    return view ? std::make_unique<MovedLists>(std::move(view), box_) : nullptr;
  }

private:
  /// The part of the box that a cube of cropped voxels is, in the source.
  Box boxIn(const Cube &cube) const {
    Box within;
    for (int axis = 0; axis < 3; ++axis) {
      within.low[axis] = box_.low[axis] + cube.low[axis];
      within.high[axis] =
          static_cast<int>(std::min<std::int64_t>(within.low[axis] + cube.side(), box_.high[axis]));
    }
    return within;
  }

  /// The aligned cubes of the source, up to eight and as large as `cube`, that it overlaps.
  std::vector<Cube> overlapped(const Cube &cube) const {
    std::vector<Cube> cubes;
    const Box within = boxIn(cube);
    const Int3 first = within.low >> cube.log2Side;
    const Int3 last = (within.high - Int3{1, 1, 1}) >> cube.log2Side;
    for (unsigned i = 0; i < 8; ++i) {
      const Int3 at = first + mortonCell(i);
      if (at.x <= last.x && at.y <= last.y && at.z <= last.z)
        cubes.push_back({at * (1 << cube.log2Side), cube.log2Side});
    }
    return cubes;
  }

  std::unique_ptr<VoxelSource> source_;
  Box box_;
  std::vector<CodedVoxel> voxels_;
};

Transform movedBy(Transform map, Int3 low) {
  map[3] += map[0] * double(low.x) + map[1] * double(low.y) + map[2] * double(low.z);
  return map;
}

} // namespace

Expected<CroppedVoxels> crop(std::unique_ptr<VoxelSource> source, const Progress &progress) {
  const auto box = VOXC_TRY(boxOf(*source, progress));
  if (box.low == Int3{})
    return CroppedVoxels{clip(std::move(source), box.high), {}};
  const Transform map = movedBy(source->voxelToModel(), box.low);
  auto lists = std::make_unique<MovedLists>(std::move(source), box);
  return CroppedVoxels{makeChunkedSource(box.high - box.low, std::move(lists), map), box.low};
}

} // namespace voxc
