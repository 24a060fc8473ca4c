// A place that is built: the scene as voxels, as a graph, and as a volume.
#pragma once

#include "Situation.h"

#include "voxc/Oracle/Oracle.h"
#include "voxc/Search/SceneDag.h"
#include "voxc/Support/Error.h"
#include "voxc/Volume/Volume.h"

#include <optional>
#include <string>
#include <vector>

namespace voxc::cliffs {

struct Stage {
  Place place;
  Oracle oracle;
  SceneDag shape; ///< As wide as the format, so that rays can be simulated on it.
  Volume volume;
  std::vector<Int3> voxels; ///< Some that are not empty.

  /// Builds all of it. Nothing, if the format takes too much memory for the scene. Errors: as of the parts.
  static Expected<std::optional<Stage>> build(const Place &place);
};

/// What rays of a situation are, in the voxels of the volume or, of instances, in their world.
struct StagedRays {
  std::vector<Ray> plain;
  std::vector<BoundedRay> bounded; ///< The same with bounds, where the situation has some; else none.

  RaySpan span() const { return bounded.empty() ? RaySpan(plain) : RaySpan(bounded); }
};

/// The rays of a situation. The same for the same arguments.
StagedRays raysOf(const Stage &stage, const Situation &situation);

/// The same rays moved off a little, so that no number of theirs is special: what they cost beside these is
/// what the numbers cost.
StagedRays movedOff(const StagedRays &rays);

/// Where a ray is in the cube [0, edge)^3 of voxels: from one t to the other, never before 0; empty if it
/// misses it.
struct Passage {
  double from = 0, to = -1;
  bool isEmpty() const { return !(from <= to); }
};
Passage passageOf(const Ray &ray, Int3 extent);

} // namespace voxc::cliffs
