// Rays that stand for those that will be asked of a scene.
#pragma once

#include "voxc/Search/FormatPredictor.h"
#include "voxc/Search/SceneDag.h"
#include "voxc/Trace/Camera.h"
#include "voxc/Trace/Ray.h"
#include "voxc/Trace/RayOrder.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace voxc {

/// `count` rays of a camera's picture (rounded down to packets of neighbours), packets spread evenly over
/// it.
std::vector<Ray> sampleCamera(const Camera &camera, std::size_t count);

/// `count` rays from surface to surface: each begins where one of `rays` hits the scene, just outside the
/// voxel, and goes any way from there; those that hit take turns. The same for a seed. None if all miss.
std::vector<Ray> sampleBounces(const SceneDag &dag, const std::vector<Ray> &rays, std::size_t count,
                               std::uint32_t seed);

/// `count` of the rays (rounded down to packets), packets spread evenly over all as a tracer takes them in a
/// volume whose longest edge has `edge` voxels: neighbours are then those that wait for each other. `Auto` is
/// that of a processor. Precondition: a packet of rays at least.
RaySet samplePackets(std::string name, std::vector<Ray> rays, std::size_t count, int edge, RayOrder order);

/// `count` of the set's rays (rounded down to packets): packets whose rays cross few cubes of the scene and
/// packets whose rays cross many as they are among all, which shows the cost of all better than as many
/// others would. They stand in this order. The whole set if it has no more.
RaySet typicalPackets(const SceneDag &dag, const RaySet &set, std::size_t count);

} // namespace voxc
