// Sources of dense grids, however their cells are stored.
#pragma once

#include "Source/OccupancyPyramid.h"
#include "voxc/Source/VoxelSource.h"
#include "voxc/Support/Progress.h"
#include "voxc/Support/WorkingMemory.h"

#include <cstdint>
#include <memory>

namespace voxc {

/// A dense grid, read row by row; by several threads at once.
class DenseRows {
public:
  virtual ~DenseRows() = default;
  /// Writes the words of `count` cells along x from `first` on. All of them lie in the grid.
  virtual void read(Int3 first, std::int32_t count, std::uint32_t *words) const = 0;
};

/// Reads the whole grid once, to know what is empty. `memory` may be null; else it is relieved while reading.
/// Error: interrupted.
Expected<std::unique_ptr<VoxelSource>> makeDenseSource(Int3 extent, std::shared_ptr<const DenseRows> rows,
                                                       const Transform &voxelToModel,
                                                       std::shared_ptr<WorkingMemory> memory,
                                                       const Progress &progress);

/// The same of a grid that knows what is empty: `occupancy` has every brick marked that holds something.
std::unique_ptr<VoxelSource> makeDenseSource(Int3 extent, std::shared_ptr<const DenseRows> rows,
                                             OccupancyPyramid occupancy, const Transform &voxelToModel,
                                             std::shared_ptr<WorkingMemory> memory);

/// A grid turned so that its +z points to +y: cell (x, y, z) is the cell (x, height - 1 - z, y) of `rows`,
/// which has `height` cells along y.
std::shared_ptr<const DenseRows> turnUpright(std::shared_ptr<const DenseRows> rows, std::int32_t height);
/// The map of a grid that was turned.
Transform turnUpright(const Transform &voxelToModel, std::int32_t height);

/// As `makeDenseSource` with progress, of a grid that is turned where its +z points up.
Expected<std::unique_ptr<VoxelSource>> makeUprightSource(Int3 extent, std::shared_ptr<const DenseRows> rows,
                                                         const Transform &voxelToModel, bool zUp,
                                                         std::shared_ptr<WorkingMemory> memory,
                                                         const Progress &progress);
/// A grid that knows what is empty; where its +z points up it is turned, and read once. Error: interrupted.
Expected<std::unique_ptr<VoxelSource>> makeUprightSource(Int3 extent, std::shared_ptr<const DenseRows> rows,
                                                         OccupancyPyramid occupancy,
                                                         const Transform &voxelToModel, bool zUp,
                                                         std::shared_ptr<WorkingMemory> memory,
                                                         const Progress &progress);

} // namespace voxc
