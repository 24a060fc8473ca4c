// Checks of a scene that no reader makes itself.
#pragma once

#include "Mesh/MeshInput.h"
#include "voxc/Mesh/TriangleScene.h"

namespace voxc {

/// Checks that there are triangles, and fewer than 2^32; that all positions are finite and all indices in
/// range. Numbers that several parts share are looked at once.
Expected<void> checkNumbers(const TriangleScene &scene, const MeshInput &input);

} // namespace voxc
