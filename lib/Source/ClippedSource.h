// A source without what lies outside an extent.
#pragma once

#include "voxc/Source/VoxelSource.h"

#include <memory>

namespace voxc {

/// The voxels of `source` in [0, extent).
std::unique_ptr<VoxelSource> clip(std::unique_ptr<VoxelSource> source, Int3 extent);

} // namespace voxc
