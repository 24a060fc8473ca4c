// Triangle meshes from PLY files.
#pragma once

#include "Mesh/Ply/PlyReader.h"
#include "voxc/Mesh/TriangleMesh.h"

namespace voxc {

/// Reads vertices with their colours, and faces as fans of triangles. Errors: as `PlyReader::readRows`, no
/// x, y, z, an index outside the vertices, triangle strips instead of faces.
Expected<TriangleMesh> readPlyMesh(PlyReader &reader);

} // namespace voxc
