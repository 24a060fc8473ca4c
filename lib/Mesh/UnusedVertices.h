// Vertices of a mesh that have no part in it.
#pragma once

#include "Mesh/MeshInput.h"
#include "voxc/Mesh/TriangleScene.h"

namespace voxc {

/// The sentence about them.
std::string saysUnused(std::uint64_t vertices);

/// Adds a warning if there are some. All indices must name vertices. Errors: interrupted, or memory.
Expected<void> warnOfUnused(TriangleScene &scene, const MeshInput &input);

} // namespace voxc
