// Scenes that show another thing of their surfaces than the colour.
#pragma once

#include "voxc/Input/Input.h"
#include "voxc/Mesh/TriangleScene.h"

namespace voxc {

/// Makes a scene's colours what `words` says; what alpha cuts out stays so. Error: no material has it.
Expected<void> showWords(TriangleScene &scene, MaterialWords words);

} // namespace voxc
