// Faces block by block: which cells it and the layers around it have, as bits, then greedy merging in
// each plane.
#include "Source/Export/Faces.h"

#include "Source/CubeTools.h"
#include "voxc/Source/Sources.h"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

namespace voxc {

namespace {

constexpr int kLog2Block = 6;
constexpr int kBlock = 1 << kLog2Block;
constexpr int kLog2Brick = 3;
constexpr int kBrick = 1 << kLog2Brick;

/// A bit for each cell of a layer of a block.
using Plane = std::array<std::uint64_t, kBlock>;
static_assert(kBlock == 64);

/// A block of voxels and which cells it and the layers around it have. Cells are bits, in rows along each
/// axis: a plane of faces is then 64 operations, and words are looked at only where a face is.
class FaceBlock {
public:
  FaceBlock(const Volume &volume, std::unique_ptr<VoxelSource> words)
      : source_(words ? std::move(words)
                      : makeVolumeSource(std::shared_ptr<const Volume>(std::shared_ptr<void>(), &volume))),
        words_(std::size_t{kBlock} * kBlock * kBlock) {}

  /// False if the block itself holds nothing. Errors: the source's.
  Expected<bool> read(Int3 low) {
    for (Layers &layers : rows_)
      layers = {};
    hasVoxel_ = false;
    Int3 brick;
    for (brick.z = -1; brick.z <= kBlock / kBrick; ++brick.z)
      for (brick.y = -1; brick.y <= kBlock / kBrick; ++brick.y)
        for (brick.x = -1; brick.x <= kBlock / kBrick; ++brick.x)
          if (axesOutside(brick) <= 1)
            VOXC_TRY(readBrick(low, brick * kBrick));
    return hasVoxel_;
  }

  /// The voxels of a layer across `axis`, from -1 to 64: a row for each cell along the axis after the next,
  /// of which bit u is the cell u along the next.
  const Plane &voxels(int axis, int layer) const {
    return rows_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(layer + 1)];
  }

  /// Of a voxel of the block itself.
  std::uint32_t word(Int3 cell) const { return words_[index(cell)]; }

private:
  using Layers = std::array<Plane, std::size_t{kBlock} + 2>;

  static std::size_t index(Int3 cell) {
    return static_cast<std::size_t>(cell.x + kBlock * (cell.y + kBlock * cell.z));
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
    VOXC_TRY(source_->read(cube, brick.data()));
    const Int3 extent = source_->extent();
    forEachCell({first, kLog2Brick}, [&](std::uint64_t at, Int3 cell) {
      if (brick[at] != 0 && contains(extent, low + cell))
        add(cell, brick[at]);
    });
    return {};
  }

  void add(Int3 cell, std::uint32_t word) {
    int outside = 0;
    for (int axis = 0; axis < 3; ++axis)
      outside += cell[axis] < 0 || cell[axis] >= kBlock;
    if (outside == 0) {
      words_[index(cell)] = word;
      hasVoxel_ = true;
    }
    for (int axis = 0; axis < 3; ++axis) {
      const bool isAcross = cell[axis] < 0 || cell[axis] >= kBlock;
      // Beside the block, a cell is a neighbour along the one axis that it lies outside on.
      if (outside > (isAcross ? 1 : 0) || cell[axis] < -1 || cell[axis] > kBlock)
        continue;
      rows_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(cell[axis] + 1)]
           [static_cast<std::size_t>(cell[(axis + 2) % 3])] |= std::uint64_t{1} << cell[(axis + 1) % 3];
    }
  }

  std::unique_ptr<VoxelSource> source_;
  std::vector<std::uint32_t> words_; ///< Those of cells that are no voxels mean nothing.
  std::array<Layers, 3> rows_{};
  bool hasVoxel_ = false;
};

/// The words of the voxels of a layer.
class PlaneWords {
public:
  PlaneWords(const FaceBlock &block, int axis, int layer) : block_(block), axis_(axis), layer_(layer) {}

  std::uint32_t at(int u, int v) const {
    Int3 cell;
    cell[axis_] = layer_;
    cell[(axis_ + 1) % 3] = u;
    cell[(axis_ + 2) % 3] = v;
    return block_.word(cell);
  }

  /// True if `width` voxels from (u, v) on all have a word.
  bool isRun(int u, int v, int width, std::uint32_t word) const {
    int same = 0;
    while (same < width && at(u + same, v) == word)
      ++same;
    return same == width;
  }

private:
  const FaceBlock &block_;
  int axis_;
  int layer_;
};

/// Which faces of a plane make one rectangle.
enum class Merge { OneColour, AnyColour };

class FaceTraversal {
public:
  /// `visit` is given words where rectangles have several colours.
  FaceTraversal(const Volume &volume, Merge merge, const VisitFaces &visit, const Progress &progress,
                std::unique_ptr<VoxelSource> words)
      : volume_(volume), merge_(merge), visit_(visit), progress_(progress), block_(volume, std::move(words)) {
  }

  Expected<void> run() {
    const Int3 extent = volume_.info().extent;
    int log2Side = kLog2Block;
    while (std::int64_t{1} << log2Side < std::max({extent.x, extent.y, extent.z}))
      ++log2Side;
    return traverse({{}, log2Side});
  }

private:
  Expected<void> traverse(const Cube &cube) {
    if (isOutside(cube, volume_.info().extent) || isEmpty(cube) || isBuried(cube))
      return {};
    if (cube.log2Side == kLog2Block)
      return traverseBlock(cube.low);
    const int half = cube.log2Side - 1;
    for (std::uint64_t child = 0; child < 8 && goes_; ++child)
      VOXC_TRY(traverse({cube.low + mortonCell(child) * (1 << half), half}));
    return {};
  }

  Expected<void> traverseBlock(Int3 low) {
    if (progress_.stopped())
      return Error::interrupted();
    const auto hasVoxel = VOXC_TRY(block_.read(low));
    if (hasVoxel)
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
    const Plane &voxels = block_.voxels(axis, layer);
    const Plane &beyond = block_.voxels(axis, layer + (isHigh ? 1 : -1));
    std::uint64_t any = 0;
    for (std::size_t v = 0; v < plane_.size(); ++v) {
      plane_[v] = voxels[v] & ~beyond[v];
      any |= plane_[v];
    }
    return any != 0;
  }

  /// Takes the widest run from each first face, and then as many equal runs as follow.
  void mergePlane(const FaceRectangle &first, int layer) {
    const PlaneWords words(block_, first.axis, layer);
    for (int v = 0; v < kBlock; ++v)
      while (row(v) != 0 && goes_) {
        const int u = std::countr_zero(row(v));
        FaceRectangle found = first;
        found.word = words.at(u, v);
        found.width = widthOf(words, u, v, found.word);
        const std::uint64_t run = (~std::uint64_t{0} >> (kBlock - found.width)) << u;
        while (v + found.height < kBlock && (row(v + found.height) & run) == run &&
               (merge_ == Merge::AnyColour || words.isRun(u, v + found.height, found.width, found.word)))
          ++found.height;
        for (int i = 0; i < found.height; ++i)
          row(v + i) &= ~run;
        found.low[first.axis] += layer;
        found.low[(first.axis + 1) % 3] += u;
        found.low[(first.axis + 2) % 3] += v;
        goes_ = visit_(found, wordsOf(words, found, u, v));
      }
  }

  /// How many faces of one word stand in a row from (u, v) on.
  int widthOf(const PlaneWords &words, int u, int v, std::uint32_t word) {
    const int most = std::countr_one(row(v) >> u);
    int width = 1;
    while (width < most && (merge_ == Merge::AnyColour || words.at(u + width, v) == word))
      ++width;
    return width;
  }

  std::span<const std::uint32_t> wordsOf(const PlaneWords &words, const FaceRectangle &face, int u, int v) {
    if (merge_ == Merge::OneColour)
      return {};
    words_.clear();
    for (int j = 0; j < face.height; ++j)
      for (int i = 0; i < face.width; ++i)
        words_.push_back(words.at(u + i, v + j));
    return words_;
  }

  std::uint64_t &row(int v) { return plane_[static_cast<std::size_t>(v)]; }

  const Volume &volume_;
  Merge merge_;
  const VisitFaces &visit_;
  const Progress &progress_;
  FaceBlock block_;
  std::vector<std::uint32_t> words_; ///< Of the rectangle in work.
  Plane plane_{};                    ///< Faces that no rectangle has yet.
  bool goes_ = true;                 ///< Until `visit` ends it.
};

} // namespace

Expected<void> forEachFace(const Volume &volume, const std::function<bool(const FaceRectangle &)> &visit,
                           const Progress &progress, std::unique_ptr<VoxelSource> words) {
  const auto visitOne = [&](const FaceRectangle &face, std::span<const std::uint32_t>) {
    return visit(face);
  };
  return FaceTraversal(volume, Merge::OneColour, visitOne, progress, std::move(words)).run();
}

Expected<void> forEachFaceOfAnyColour(const Volume &volume, const VisitFaces &visit, const Progress &progress,
                                      std::unique_ptr<VoxelSource> words) {
  return FaceTraversal(volume, Merge::AnyColour, visit, progress, std::move(words)).run();
}

} // namespace voxc
