// Is a scene fit to be voxelized, and how large is it?
#pragma once

#include "Mesh/ModelFrame.h"
#include "Mesh/Voxelize/TriangleCursor.h"
#include "voxc/Mesh/TriangleScene.h"

namespace voxc {

/// Errors: an index of a part, a material or a texture outside what it points into, too few rows or texels.
Expected<void> checkReferences(const TriangleScene &scene);

/// The box of all triangles of a checked scene. Errors: no triangle, or 2^32 or more; a vertex that does not
/// exist or is not finite; asked to stop.
Expected<Bounds> boundsOf(const TriangleScene &scene, const TriangleNumbers &numbers, WorkingMemory *memory,
                          const Progress &progress);

} // namespace voxc
