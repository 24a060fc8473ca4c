// What rays should cost, by the speed model of search (voxc/Search/SpeedModel.h) on some of them.
#pragma once

#include "Subject.h"

#include "voxc/Search/SpeedModel.h"

#include <vector>

namespace voxc::cliffs {

/// What the model does not know of a machine; measured at the start.
struct Calibration {
  double scale = 1;   ///< Of the model's times.
  double perCall = 0; ///< Nanoseconds of a call with one ray and nothing in its way.
};

struct Expectation {
  double nanoseconds = 0; ///< Of a call.
  double lookups = 0;     ///< Of a ray, as kernels count them; of instances 0.
  double visits = 1;      ///< Instances that a ray should be traced through.
};

/// Some of the rays: whole packets of neighbours, spread evenly; all, if they are few.
StagedRays someOf(const StagedRays &rays, std::size_t count);

/// Of the rays that a subject has just traced. `some` are some of them.
Expected<Expectation> expect(const Machine &machine, const Calibration &calibration, const Stage &stage,
                             const Situation &situation, const Subject &subject, const StagedRays &all,
                             const StagedRays &some);

} // namespace voxc::cliffs
