// The plane that runs through a neighbourhood of voxels.
#pragma once

#include "Occupancy.h"

#include <glm/vec3.hpp>

namespace voxc {

/// The direction, of either sign, in which the voxels of a neighbourhood spread least: the normal of the
/// surface that they are on, whether that is a shell or a body behind it. Zero where they spread evenly, as a
/// heap or a hair does, or are too few to tell.
glm::vec3 planeNormal(const Neighbourhood &voxels);

} // namespace voxc
