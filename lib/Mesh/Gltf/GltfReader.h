// Reading .glb and .gltf.
#pragma once

#include "Mesh/MeshInput.h"
#include "voxc/Mesh/TriangleScene.h"

namespace voxc {

/// Reads a glTF 2.0 model; its buffers stay where they are, in mapped files. What is not checked: that
/// coordinates are finite and indices in range. Errors: a field of the wrong type or out of range, a missing
/// buffer, a required extension that is not read.
Expected<TriangleScene> readGltf(const MeshInput &input);

} // namespace voxc
