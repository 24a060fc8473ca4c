// Materials and textures of a scene that assimp has imported.
#pragma once

#include "voxc/Mesh/TriangleMesh.h"

#include <string>
#include <vector>

struct aiScene;

namespace voxc {

/// Fills `mesh.materials`, one for each of the scene, and `mesh.textures`; what is missing or broken becomes
/// a warning. Answers which set of texture coordinates each material takes.
std::vector<unsigned> readMaterials(const aiScene &scene, const std::string &folder, TriangleMesh &mesh);

} // namespace voxc
