// The functions of an intersection kernel: all but what ties it to a target's memory and dispatch.
#pragma once

#include "KernelBuilder.h"

namespace voxc {

/// From the ray to the root: the leaves that the plan names, in order of use, with each level's constants.
/// They call `load_word`.
void addKernelFunctions(KernelBuilder &builder);

/// The constant VOLUME_SIZE, voxels along each axis.
void addVolumeSize(KernelBuilder &builder);

} // namespace voxc
