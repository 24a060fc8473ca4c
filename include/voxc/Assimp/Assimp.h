// The optional component that reads meshes through assimp.
#pragma once

#include "voxc/Input/Input.h"

#include <vector>

namespace voxc {

/// Reads .fbx, .dae, .3ds, .off and .x3d files: triangles, polygons, lines and points where the nodes of the
/// scene place them, vertex colours, and of materials the diffuse colour, the opacity and the diffuse
/// texture, beside the file or within it. What else a file has (skins, morphs, animations, other textures) is
/// a warning. Memory that assimp takes is not within `InputOptions::memory`; each file is read in a process
/// of its own first, so that one that assimp does not survive is an error. Errors: what assimp cannot read,
/// and those of `loadScene`.
std::vector<InputKind> assimpKinds();

} // namespace voxc
