// Reading .ply with faces.
#pragma once

#include "Mesh/MeshInput.h"
#include "voxc/Mesh/TriangleScene.h"

namespace voxc {

/// Reads vertices with their colours, faces and triangle strips. Errors: as `PlyReader::readRows`, which name
/// the path; no x, y, z; no list of corners; a corner that does not exist.
Expected<TriangleScene> readPlyScene(const MeshInput &input);

} // namespace voxc
