// Dense grids: which of their cubes are empty is found out once, words are read when they are asked for.
#include "Source/DenseSource.h"

#include "Source/CubeTools.h"

#include <algorithm>
#include <array>
#include <utility>

namespace voxc {

namespace {

constexpr std::int32_t kBrick = 1 << OccupancyPyramid::kLog2Brick;

/// What all views of a grid share.
struct Grid {
  Int3 extent;
  std::shared_ptr<const DenseRows> rows;
  Transform voxelToModel;
  std::shared_ptr<WorkingMemory> memory;
  OccupancyPyramid occupancy;

  void relieve() const {
    if (memory)
      memory->relieve();
  }
};

class DenseSource final : public VoxelSource {
public:
  explicit DenseSource(std::shared_ptr<const Grid> grid) : grid_(std::move(grid)) {}

  Int3 extent() const override { return grid_->extent; }
  Transform voxelToModel() const override { return grid_->voxelToModel; }
  std::unique_ptr<VoxelSource> view() const override { return std::make_unique<DenseSource>(grid_); }

  bool empty(const Cube &cube) override {
    if (isOutside(cube, grid_->extent))
      return true;
    if (cube.log2Side >= OccupancyPyramid::kLog2Brick)
      return grid_->occupancy.empty(cube);
    std::array<std::uint32_t, 512> words;
    if (!read(cube, words.data()))
      return false;
    const auto *const end = words.data() + cellCount(cube.log2Side);
    return std::all_of(std::as_const(words).data(), end, [](std::uint32_t word) { return word == 0; });
  }

  Expected<void> read(const Cube &cube, std::uint32_t *words) override {
    std::fill_n(words, cellCount(cube.log2Side), 0u);
    if (isOutside(cube, grid_->extent))
      return {};
    grid_->relieve();
    const Int3 rest = grid_->extent - cube.low;
    const auto side = static_cast<std::int32_t>(cube.side());
    const Int3 size{std::min(side, rest.x), std::min(side, rest.y), std::min(side, rest.z)};
    std::array<std::uint32_t, kBrick> row;
    for (Int3 cell; cell.z < size.z; ++cell.z)
      for (cell.y = 0; cell.y < size.y; ++cell.y) {
        grid_->rows->read(cube.low + Int3{0, cell.y, cell.z}, size.x, row.data());
        std::uint32_t *const target = words + mortonCode({0, cell.y, cell.z});
        for (std::int32_t x = 0; x < size.x; ++x)
          target[kSpread[static_cast<std::size_t>(x)]] = row[static_cast<std::size_t>(x)];
      }
    return {};
  }

private:
  /// Every third bit of a place in a row of a brick.
  static constexpr std::array<std::uint8_t, kBrick> kSpread{0, 1, 8, 9, 64, 65, 72, 73};

  std::shared_ptr<const Grid> grid_;
};

/// Marks the bricks around the cells of a row that are not empty.
class RowMarker {
public:
  explicit RowMarker(Grid &grid)
      : grid_(grid), words_(static_cast<std::size_t>(std::min(grid.extent.x, kMostCells))) {}

  void mark(std::int32_t y, std::int32_t z) {
    for (std::int32_t x = 0; x < grid_.extent.x; x += kMostCells) {
      const std::int32_t count = std::min(kMostCells, grid_.extent.x - x);
      grid_.rows->read({x, y, z}, count, words_.data());
      markPart({x, y, z}, count);
    }
  }

private:
  static constexpr std::int32_t kMostCells = 1 << 14; ///< A multiple of a brick's side.

  void markPart(Int3 first, std::int32_t count) {
    for (std::int32_t begin = 0; begin < count; begin += kBrick) {
      std::uint32_t any = 0;
      for (std::int32_t x = begin; x < std::min(begin + kBrick, count); ++x)
        any |= words_[static_cast<std::size_t>(x)];
      if (any != 0)
        grid_.occupancy.mark(first + Int3{begin, 0, 0});
    }
  }

  Grid &grid_;
  std::vector<std::uint32_t> words_;
};

class TurnedRows final : public DenseRows {
public:
  TurnedRows(std::shared_ptr<const DenseRows> rows, std::int32_t height)
      : rows_(std::move(rows)), height_(height) {}

  void read(Int3 first, std::int32_t count, std::uint32_t *words) const override {
    rows_->read({first.x, height_ - 1 - first.z, first.y}, count, words);
  }

private:
  std::shared_ptr<const DenseRows> rows_;
  std::int32_t height_;
};

} // namespace

Expected<std::unique_ptr<VoxelSource>> makeDenseSource(Int3 extent, std::shared_ptr<const DenseRows> rows,
                                                       const Transform &voxelToModel,
                                                       std::shared_ptr<WorkingMemory> memory,
                                                       const Progress &progress) {
  auto grid = std::make_shared<Grid>(
      Grid{extent, std::move(rows), voxelToModel, std::move(memory), OccupancyPyramid(extent)});
  RowMarker marker(*grid);
  for (std::int32_t z = 0; z < extent.z; ++z) {
    progress.at("load", static_cast<double>(z) / extent.z);
    for (std::int32_t y = 0; y < extent.y; ++y) {
      VOXC_TRY(progress.check());
      marker.mark(y, z);
      grid->relieve();
    }
  }
  return std::unique_ptr<VoxelSource>(std::make_unique<DenseSource>(std::move(grid)));
}

std::unique_ptr<VoxelSource> makeDenseSource(Int3 extent, std::shared_ptr<const DenseRows> rows,
                                             OccupancyPyramid occupancy, const Transform &voxelToModel,
                                             std::shared_ptr<WorkingMemory> memory) {
  return std::make_unique<DenseSource>(std::make_shared<const Grid>(
      Grid{extent, std::move(rows), voxelToModel, std::move(memory), std::move(occupancy)}));
}

std::shared_ptr<const DenseRows> turnUpright(std::shared_ptr<const DenseRows> rows, std::int32_t height) {
  return std::make_shared<TurnedRows>(std::move(rows), height);
}

Transform turnUpright(const Transform &voxelToModel, std::int32_t height) {
  const auto &[x, y, z, origin] =
      std::array{voxelToModel[0], voxelToModel[1], voxelToModel[2], voxelToModel[3]};
  return {x, z, -y, origin + y * static_cast<double>(height)};
}

Expected<std::unique_ptr<VoxelSource>> makeUprightSource(Int3 extent, std::shared_ptr<const DenseRows> rows,
                                                         const Transform &voxelToModel, bool zUp,
                                                         std::shared_ptr<WorkingMemory> memory,
                                                         const Progress &progress) {
  if (!zUp)
    return makeDenseSource(extent, std::move(rows), voxelToModel, std::move(memory), progress);
  return makeDenseSource({extent.x, extent.z, extent.y}, turnUpright(std::move(rows), extent.y),
                         turnUpright(voxelToModel, extent.y), std::move(memory), progress);
}

Expected<std::unique_ptr<VoxelSource>> makeUprightSource(Int3 extent, std::shared_ptr<const DenseRows> rows,
                                                         OccupancyPyramid occupancy,
                                                         const Transform &voxelToModel, bool zUp,
                                                         std::shared_ptr<WorkingMemory> memory,
                                                         const Progress &progress) {
  if (!zUp)
    return makeDenseSource(extent, std::move(rows), std::move(occupancy), voxelToModel, std::move(memory));
  return makeUprightSource(extent, std::move(rows), voxelToModel, zUp, std::move(memory), progress);
}

} // namespace voxc
