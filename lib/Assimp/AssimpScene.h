// A scene of assimp's as one of ours.
#pragma once

#include "Mesh/MeshInput.h"
#include "Support/Warnings.h"
#include "voxc/Mesh/TriangleScene.h"

#include <assimp/scene.h>

namespace voxc {

/// Copies meshes, materials and nodes. What is not copied becomes a warning. Errors: interrupted, no memory.
Expected<TriangleScene> sceneOf(const aiScene &from, const MeshInput &input, Warnings &warnings);

} // namespace voxc
