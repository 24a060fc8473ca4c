// Writing MagicaVoxel files, and visiting the voxels of a volume.
#pragma once

#include "Source/CubeTools.h"
#include "voxc/Support/File.h"
#include "voxc/Volume/Volume.h"

namespace voxc {

/// Calls `visit(voxel, word)` for every voxel of the volume in Morton order; a file that lies about its
/// extent may have some outside, which are left out.
template <typename Visit> void forEachVoxel(const Volume &volume, Visit visit) {
  decode(volume, [&](const Cube &cube, std::uint32_t word) {
    forEachCell(cube, [&](std::uint64_t, Int3 voxel) {
      if (contains(volume.info().extent, voxel))
        visit(voxel, word);
    });
  });
}

/// Writes models of at most 256 cells a side, placed by a scene graph, with a palette. MagicaVoxel's up is
/// +z, so +y is turned to it. Error: more than 255 colours.
Expected<void> writeMagicaVoxel(const Volume &volume, OutputFile &file);

} // namespace voxc
