// Writing MagicaVoxel files, and visiting the voxels of a volume.
#pragma once

#include "Source/CubeTools.h"
#include "voxc/Support/File.h"
#include "voxc/Volume/Volume.h"

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

/// Writes models of at most 256 cells a side, placed by a scene graph, with a palette. MagicaVoxel's up is
/// +z, so +y is turned to it. Errors: more than 255 colours or 2^29 voxels; as
/// `decode`.
Expected<void> writeMagicaVoxel(const Volume &volume, OutputFile &file, const Progress &progress);

} // namespace voxc
