// Cameras that stand inside of a volume.
#pragma once

#include "voxc/Render/Render.h"

#include <optional>

namespace voxc {

/// Somewhere within, in voxels, and the level direction around which most is to be seen.
struct Place {
  glm::dvec3 eye{};
  glm::dvec3 direction{0, 0, -1}; ///< In spaced space, unit length.
  double worth = 0;               ///< The more, the more is to be seen; 0: nothing.
};

/// The best of many places on a grid at several heights near the ground.
Expected<Place> bestPlace(const glm::dvec3 &extent, const glm::dvec3 &spacing, TraceRays trace);

/// Whether the place is surely one in a room, a building or a yard: rays from there see far and much.
Expected<bool> isInRoom(const Place &place, const glm::dvec3 &extent, const glm::dvec3 &spacing,
                        TraceRays trace);

} // namespace voxc
