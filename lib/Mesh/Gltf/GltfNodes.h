// The node tree of a glTF model as instances of parts.
#pragma once

#include "Mesh/Gltf/GltfMeshes.h"

namespace voxc {

/// Adds an instance for each part of each node's mesh to the scene, in the order of the tree. Problems: nodes
/// that make no tree, transforms that are not finite, too many instances.
void readGltfNodes(GltfContext &context, GltfMeshes &meshes, GltfAccessors &accessors, GltfPoses &poses);

} // namespace voxc
