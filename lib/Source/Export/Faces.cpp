// Faces block by block: the words of a block and of the layers around it, then greedy merging in each plane.
#include "Source/Export/Faces.h"

#include "Source/CubeTools.h"
#include "voxc/Source/Sources.h"

#include <algorithm>
#include <array>
#include <vector>

namespace voxc {

namespace {

constexpr int kLog2Block = 6;
constexpr int kBlock = 1 << kLog2Block;
constexpr int kLog2Brick = 3;
constexpr int kBrick = 1 << kLog2Brick;

/// The words of a block with one cell more on each side.
class BlockWords {
public:
  explicit BlockWords(const Volume &volume)
      : source_(makeVolumeSource(std::shared_ptr<const Volume>(std::shared_ptr<void>(), &volume))),
        words_(std::size_t{kSide} * kSide * kSide) {}

  /// False if the block itself holds nothing. Errors: the source's.
  Expected<bool> read(Int3 low) {
    std::ranges::fill(words_, 0u);
    hasVoxel_ = false;
    Int3 brick;
    for (brick.z = -1; brick.z <= kBlock / kBrick; ++brick.z)
      for (brick.y = -1; brick.y <= kBlock / kBrick; ++brick.y)
        for (brick.x = -1; brick.x <= kBlock / kBrick; ++brick.x)
          if (axesOutside(brick) <= 1)
            if (auto done = readBrick(low, brick * kBrick); !done)
              return done.error();
    return hasVoxel_;
  }

  std::uint32_t at(Int3 cell) const { return words_[index(cell)]; }

private:
  static constexpr int kSide = kBlock + 2;

  static std::size_t index(Int3 cell) {
    return static_cast<std::size_t>(cell.x + 1 + kSide * (cell.y + 1 + kSide * (cell.z + 1)));
  }

  /// Bricks that touch the block at an edge or a corner alone hold no neighbour of a voxel.
  static int axesOutside(Int3 brick) {
    int count = 0;
    for (int axis = 0; axis < 3; ++axis)
      count += brick[axis] < 0 || brick[axis] >= kBlock / kBrick;
    return count;
  }

  Expected<void> readBrick(Int3 low, Int3 first) {
    const Cube cube{low + first, kLog2Brick};
    if (source_->empty(cube))
      return {};
    std::array<std::uint32_t, std::size_t{kBrick} * kBrick * kBrick> brick;
    if (auto done = source_->read(cube, brick.data()); !done)
      return done;
    const Int3 extent = source_->extent();
    forEachCell({first, kLog2Brick}, [&](std::uint64_t at, Int3 cell) {
      const bool isNear =
          std::min({cell.x, cell.y, cell.z}) >= -1 && std::max({cell.x, cell.y, cell.z}) <= kBlock;
      if (brick[at] == 0 || !isNear || !contains(extent, low + cell))
        return;
      words_[index(cell)] = brick[at];
      hasVoxel_ |= contains({kBlock, kBlock, kBlock}, cell);
    });
    return {};
  }

  std::unique_ptr<VoxelSource> source_;
  std::vector<std::uint32_t> words_;
  bool hasVoxel_ = false;
};

/// The faces of one plane of a block, as the words of their voxels; 0: no face.
using Plane = std::array<std::uint32_t, std::size_t{kBlock} * kBlock>;

class FaceWalk {
public:
  FaceWalk(const Volume &volume, const std::function<bool(const FaceRectangle &)> &visit,
           const Progress &progress)
      : volume_(volume), visit_(visit), progress_(progress), words_(volume) {}

  Expected<void> run() {
    const Int3 extent = volume_.info().extent;
    int log2Side = kLog2Block;
    while (std::int64_t{1} << log2Side < std::max({extent.x, extent.y, extent.z}))
      ++log2Side;
    return walk({{}, log2Side});
  }

private:
  Expected<void> walk(const Cube &cube) {
    if (isOutside(cube, volume_.info().extent) || isEmpty(cube) || isBuried(cube))
      return {};
    if (cube.log2Side == kLog2Block)
      return walkBlock(cube.low);
    const int half = cube.log2Side - 1;
    for (std::uint64_t child = 0; child < 8 && goes_; ++child)
      if (auto walked = walk({cube.low + mortonCell(child) * (1 << half), half}); !walked)
        return walked;
    return {};
  }

  Expected<void> walkBlock(Int3 low) {
    if (progress_.stopped())
      return Error::interrupted();
    const Expected<bool> hasVoxel = words_.read(low);
    if (!hasVoxel)
      return hasVoxel.error();
    if (*hasVoxel)
      mergeBlock(low);
    return {};
  }

  bool isEmpty(const Cube &cube) const {
    const Lookup found = volume_.lookup(cube.low);
    return found.value == 0 && found.log2Side >= cube.log2Side;
  }

  bool isSolid(const Cube &cube) const {
    const std::int32_t last = static_cast<std::int32_t>(cube.side() - 1);
    if (!contains(volume_.info().extent, cube.low) ||
        !contains(volume_.info().extent, cube.low + Int3{last, last, last}))
      return false;
    const Lookup found = volume_.lookup(cube.low);
    return found.value != 0 && found.log2Side >= cube.log2Side;
  }

  /// True of a cube of voxels between six such cubes, which has no visible face.
  bool isBuried(const Cube &cube) const {
    if (!isSolid(cube))
      return false;
    for (int axis = 0; axis < 3; ++axis)
      for (const int sign : {-1, 1}) {
        Cube beside = cube;
        beside.low[axis] += sign * static_cast<std::int32_t>(cube.side());
        if (!isSolid(beside))
          return false;
      }
    return true;
  }

  void mergeBlock(Int3 low) {
    for (int axis = 0; axis < 3; ++axis)
      for (const bool isHigh : {false, true})
        for (int layer = 0; layer < kBlock && goes_; ++layer)
          if (readPlane(axis, isHigh, layer))
            mergePlane({axis, isHigh, low, 1, 1, 0}, layer);
  }

  /// False if the plane has no face.
  bool readPlane(int axis, bool isHigh, int layer) {
    bool hasFace = false;
    Int3 cell;
    cell[axis] = layer;
    for (int v = 0; v < kBlock; ++v)
      for (int u = 0; u < kBlock; ++u) {
        cell[(axis + 1) % 3] = u;
        cell[(axis + 2) % 3] = v;
        Int3 beyond = cell;
        beyond[axis] += isHigh ? 1 : -1;
        const std::uint32_t word = words_.at(cell) != 0 && words_.at(beyond) == 0 ? words_.at(cell) : 0;
        plane_[static_cast<std::size_t>(u + kBlock * v)] = word;
        hasFace |= word != 0;
      }
    return hasFace;
  }

  /// Takes the widest run from each first face, and then as many equal runs as follow.
  void mergePlane(const FaceRectangle &block, int layer) {
    for (int v = 0; v < kBlock; ++v)
      for (int u = 0; u < kBlock && goes_; ++u) {
        const std::uint32_t word = face(u, v);
        if (word == 0)
          continue;
        FaceRectangle found = block;
        found.word = word;
        while (u + found.width < kBlock && face(u + found.width, v) == word)
          ++found.width;
        while (v + found.height < kBlock && isRun(u, v + found.height, found.width, word))
          ++found.height;
        for (int row = 0; row < found.height; ++row)
          std::fill_n(&face(u, v + row), found.width, 0u);
        found.low[block.axis] += layer;
        found.low[(block.axis + 1) % 3] += u;
        found.low[(block.axis + 2) % 3] += v;
        goes_ = visit_(found);
      }
  }

  std::uint32_t &face(int u, int v) { return plane_[static_cast<std::size_t>(u + kBlock * v)]; }

  bool isRun(int u, int v, int width, std::uint32_t word) {
    const std::uint32_t *first = &face(u, v);
    return std::all_of(first, first + width, [&](std::uint32_t other) { return other == word; });
  }

  const Volume &volume_;
  const std::function<bool(const FaceRectangle &)> &visit_;
  const Progress &progress_;
  BlockWords words_;
  Plane plane_{};
  bool goes_ = true; ///< Until `visit` ends it.
};

} // namespace

Expected<void> forEachFace(const Volume &volume, const std::function<bool(const FaceRectangle &)> &visit,
                           const Progress &progress) {
  return FaceWalk(volume, visit, progress).run();
}

} // namespace voxc
