// Double-sided meshes whose sides are cut into triangles in different ways: of a quad one side has one
// diagonal, and the other side the other.
#pragma once

#include "Mesh/Solid/TriangleSet.h"

#include <memory>

namespace voxc {

/// Whether a scene winds around so little of its box that it may be double-sided. Error: interrupted.
Expected<bool> hasLittleVolume(const TriangleScene &scene, const MeshModel &model, WorkingMemory &memory,
                               const Progress &progress);

/// Adds the two triangles of one side of each such quad to `twins`: two triangles that share an edge which no
/// other one has, and two that share the other diagonal of the same four corners and look the other way.
/// Corners are those of the snapped triangles, compared by hashes of 64 bits. Says whether there were any.
/// Errors: interrupted, no memory.
Expected<bool> addTwinQuads(TriangleSet &twins, const TriangleScene &scene, const MeshModel &model,
                            const std::shared_ptr<WorkingMemory> &memory, const Progress &progress);

} // namespace voxc
