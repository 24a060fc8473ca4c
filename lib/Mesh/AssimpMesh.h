// Triangle meshes from the formats that assimp reads.
#pragma once

#include "voxc/Mesh/TriangleMesh.h"

#include <string>

namespace voxc {

/// Imports a file with its materials, textures and node transforms. Errors: what assimp says.
Expected<TriangleMesh> readAssimpMesh(const std::string &path);

} // namespace voxc
