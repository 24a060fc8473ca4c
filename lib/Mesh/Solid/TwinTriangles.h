// Triangles that lie on others which face the other way: the back sides of double-sided meshes.
#pragma once

#include "Mesh/Solid/TriangleSet.h"

#include <memory>

namespace voxc {

/// One of each kind of triangles with the same snapped corners of which as many turn one way as the other:
/// the winding number knows nothing of them. They are compared by hashes of 64 bits. Errors: interrupted, no
/// memory.
Expected<TriangleSet> findTwins(const TriangleScene &scene, const MeshModel &model,
                                const std::shared_ptr<WorkingMemory> &memory, const Progress &progress);

} // namespace voxc
