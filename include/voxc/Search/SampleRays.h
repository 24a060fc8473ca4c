// Rays that stand for those that will be asked of a scene.
#pragma once

#include "voxc/Search/SceneDag.h"
#include "voxc/Trace/Camera.h"
#include "voxc/Trace/Ray.h"

#include <cstdint>
#include <vector>

namespace voxc {

/// `count` rays of a camera's picture (rounded down to packets of 16 neighbours), packets spread evenly over
/// it.
std::vector<Ray> sampleCamera(const Camera &camera, std::size_t count);

/// As many rays from surface to surface: each begins where one of `rays` hits the scene, just outside the
/// voxel, and goes any way from there; of rays that miss, others take the place. The same for a seed. None if
/// all miss.
std::vector<Ray> sampleBounces(const SceneDag &dag, const std::vector<Ray> &rays, std::uint32_t seed);

} // namespace voxc
