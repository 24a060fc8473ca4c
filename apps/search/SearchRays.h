// The rays that a search measures by.
#pragma once

#include "search/SearchOptions.h"

#include "choosing/Scene.h"
#include "sweep/Cells.h"
#include "voxc/Measure/MeasuredSet.h"

#include <vector>

namespace voxc::tool {

/// One model with its rays, one precision and one device; formats are still to be named. What a machine needs
/// to make the rays again is kept in the cache of the folder. Errors: those of cameras, rays and devices.
Expected<bench::SweepAxes> makeSearchAxes(const SearchOptions &options, const Scene &scene);

/// The rays of the axes, for a scene.
std::vector<measure::MeasuredSet> measuredSets(const Scene &scene, const bench::SweepAxes &axes);

} // namespace voxc::tool
