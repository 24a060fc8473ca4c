// What a mesh says of itself: triangles, box and colours.
#pragma once

#include "voxc/Input/Input.h"
#include "voxc/Mesh/TriangleScene.h"

#include <vector>

namespace voxc {

/// Facts of a scene, whose vertices are all looked at.
std::vector<InputFact> factsOf(const TriangleScene &scene);

} // namespace voxc
