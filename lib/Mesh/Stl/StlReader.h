// Reading .stl, binary and text.
#pragma once

#include "Mesh/MeshInput.h"
#include "voxc/Mesh/TriangleScene.h"

namespace voxc {

/// Reads the triangles, and the colours of binary files; normals mean nothing. Errors: a file that is cut
/// short or no STL.
Expected<TriangleScene> readStl(const MeshInput &input);

} // namespace voxc
