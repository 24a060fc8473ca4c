// Is a mesh fit to be voxelized?
#pragma once

#include "voxc/Mesh/TriangleMesh.h"

namespace voxc {

/// Errors: no triangle, an index outside what it points into, a vertex that is not finite.
Expected<void> checkMesh(const TriangleMesh &mesh);

} // namespace voxc
