// Visiting the voxels of a volume, and reading boxes of them.
#pragma once

#include "Source/CubeTools.h"
#include "voxc/Support/FunctionRef.h"
#include "voxc/Volume/Volume.h"

#include <span>

namespace voxc {

/// The side of the cubes that are read from a volume as a whole.
inline constexpr int kLog2CubeAtOnce = 3;
inline constexpr std::int32_t kCubeAtOnce = 1 << kLog2CubeAtOnce;

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

/// Writes the words of the cells in [low, high), x fastest, then y, then z. Fastest where it begins and ends
/// at multiples of eight cells: each cube of 8^3 is read as a whole.
void readBox(const Volume &volume, Int3 low, Int3 high, std::span<std::uint32_t> words);

/// Calls `visit` with the words of all cells, x fastest, then y, then z, many at once. Errors: those of
/// `visit`; interrupted.
Expected<void> forEachRun(const Volume &volume, const Progress &progress,
                          FunctionRef<Expected<void>(std::span<const std::uint32_t>)> visit);

} // namespace voxc
