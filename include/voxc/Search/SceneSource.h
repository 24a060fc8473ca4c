// Voxels out of a scene's graph: what candidates are built from, so that an input is read once.
#pragma once

#include "voxc/Search/SceneDag.h"
#include "voxc/Source/VoxelSource.h"

#include <memory>

namespace voxc {

/// A source of the voxels of a graph with colours, which must outlive it and its views. `extent` and
/// `voxelToModel` are those of the source that the graph was read from.
std::unique_ptr<VoxelSource> makeSceneSource(const SceneDag &dag, Int3 extent, const Transform &voxelToModel);

} // namespace voxc
