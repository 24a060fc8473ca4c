// The rays of a search: those that formats are measured by, and some of them to be simulated.
#pragma once

#include "search/SearchOptions.h"

#include "choosing/Scene.h"
#include "sweep/Cells.h"

#include <vector>

namespace voxc::tool {

/// One model with its rays, one precision and one device; formats are still to be named. What a machine needs
/// to make the rays again is kept in the cache of the folder. Errors: those of cameras, rays and devices.
Expected<bench::SweepAxes> makeSearchAxes(const SearchOptions &options, const Scene &scene);

/// Rays that stand for the measured ones, in the order in which the device takes them.
std::vector<RaySet> simulatedRays(const Scene &scene, const bench::SweepAxes &axes);

} // namespace voxc::tool
