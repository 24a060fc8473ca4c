// Reading .obj with its .mtl and images.
#pragma once

#include "Mesh/MeshInput.h"
#include "voxc/Mesh/TriangleScene.h"

namespace voxc {

/// Reads faces, lines and points with their materials; vertex colours as three numbers behind the
/// coordinates. Free-form curves and surfaces, and what is missing, become warnings. Errors: a line that
/// makes no sense, a corner that does not exist.
Expected<TriangleScene> readObj(const MeshInput &input);

} // namespace voxc
