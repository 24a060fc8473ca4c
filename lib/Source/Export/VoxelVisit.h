// Visiting the voxels of a volume, and their rows.
#pragma once

#include "Source/CubeTools.h"
#include "voxc/Volume/Volume.h"

#include <algorithm>
#include <span>

namespace voxc {

/// Calls `visit(voxel, word)`, which returns false to end, for every voxel of the volume in Morton order; a
/// file that lies about its extent may have some outside, which are left out. Errors: as `decode`.
template <typename Visit>
Expected<void> forEachVoxel(const Volume &volume, const Progress &progress, Visit visit) {
  const Int3 extent = volume.info().extent;
  constexpr std::uint64_t kVoxelsBetweenLooks = 1 << 16;
  bool stopped = false;
  const auto visitCube = [&](const Cube &cube, std::uint32_t word) {
    for (std::uint64_t index = 0; index < cellCount(cube.log2Side); ++index) {
      const Int3 voxel = cube.low + mortonCell(index);
      stopped = index % kVoxelsBetweenLooks == kVoxelsBetweenLooks - 1 && progress.stopped();
      if (stopped || (contains(extent, voxel) && !visit(voxel, word)))
        return false;
    }
    return true;
  };
  auto decoded = decode(volume, visitCube, progress);
  if (stopped)
    return Error::interrupted();
  return decoded;
}

/// Writes the words of a row along x from `cell` on: a lookup for each run of equal ones that the volume
/// stores.
inline void readRow(const Volume &volume, Int3 cell, std::span<std::uint32_t> row) {
  const std::int32_t first = cell.x;
  const std::int64_t width = first + static_cast<std::int64_t>(row.size());
  while (cell.x < width) {
    const Lookup found = volume.lookup(cell);
    const std::int64_t side = std::int64_t{1} << found.log2Side;
    const std::int64_t end = std::min<std::int64_t>((cell.x & -side) + side, width);
    for (; cell.x < end; ++cell.x)
      row[static_cast<std::size_t>(cell.x - first)] = found.value;
  }
}

} // namespace voxc
