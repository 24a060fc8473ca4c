// The colour of a mesh at a point of one of its triangles.
#pragma once

#include "Mesh/ModelFrame.h"
#include "voxc/Mesh/TriangleMesh.h"

#include <cstdint>

namespace voxc {

/// The word at the point with these weights, or 0 where a texture or mask cuts the triangle away: below one
/// half of alpha. What remains has the alpha of the material and the vertices, but at least 1, so that the
/// word is not "empty".
std::uint32_t surfaceColour(const TriangleMesh &mesh, const Triangle &triangle, const Double3 &weights);

} // namespace voxc
