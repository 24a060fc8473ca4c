// Random rays for property tests.
#pragma once

#include "voxc/Support/Geometry.h"
#include "voxc/Trace/Ray.h"

#include <cstddef>
#include <random>
#include <vector>

namespace voxc::test {

/// Rays from within three times a volume of `extent` voxels, about its middle, to a place in it. Their
/// directions have any length.
std::vector<Ray> raysInto(Int3 extent, std::size_t count, std::mt19937 &random);

} // namespace voxc::test
