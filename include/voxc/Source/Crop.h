// A source moved so that no empty border is left.
#pragma once

#include "voxc/Source/VoxelSource.h"
#include "voxc/Support/Progress.h"

#include <memory>

namespace voxc {

/// The voxels of a source in their smallest box, and where the box lies in the source.
struct CroppedVoxels {
  std::unique_ptr<VoxelSource> source;
  Int3 low; ///< Voxel v of `source` is voxel v + low of the one that was cropped.
};

/// Moves the low corner of the smallest box around all voxels of `source` to (0, 0, 0); the extent is that of
/// the box, and `voxelToModel` maps to the same points as before. Without a voxel it is one empty cell.
/// Reads, before it returns, what of the source may reach out of the box of what was read. Errors: that of a
/// source that fails, interrupted.
Expected<CroppedVoxels> crop(std::unique_ptr<VoxelSource> source, const Progress &progress = {});

} // namespace voxc
