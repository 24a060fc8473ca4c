// Which cells lie inside a closed mesh, each asked for itself.
#pragma once

#include "Mesh/Solid/ClosedMesh.h"
#include "Mesh/Voxelize/VoxelRule.h"
#include "Source/Interior/BrickCells.h"

#include <memory>

namespace voxc {

/// The voxels that triangles which close holes take, in Morton order. Errors: interrupted, no memory.
Expected<ScratchArray<BrickCells>> voxelsOfCaps(const ClosedMesh &mesh, const VoxelRule &rule,
                                                const std::shared_ptr<WorkingMemory> &memory,
                                                const Progress &progress);

/// Leaves those of `bricks` whose centres are inside, going through all triangles for each two million cells.
/// Errors: interrupted, no memory.
Expected<void> keepInside(ScratchArray<BrickCells> &bricks, const ClosedMesh &mesh,
                          const std::shared_ptr<WorkingMemory> &memory, const Progress &progress);

} // namespace voxc
