// The functions of an intersection kernel: all but what ties it to a target's memory and dispatch.
#pragma once

#include "voxc/Plan/Plan.h"

#include <string>

namespace voxc {

/// GLSL from the ray to the root: the runtime files that the plan names, in order of use, with each level's
/// constants. They call `load_word`.
std::string kernelFunctions(const Plan &plan);

/// "// Voxels along each axis." and the constant, with an empty line before it.
std::string volumeSize(const Plan &plan);

} // namespace voxc
