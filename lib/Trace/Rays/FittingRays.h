// Rays as a kernel takes them: with bounds or without.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Trace/BoundedRay.h"

#include <vector>

namespace voxc {

/// Keeps the memory of copies from one call to the next, as tracers keep all that follows the number of rays:
/// pages that the system gives anew cost more than the copies in them.
class FittingRays {
public:
  /// The given rays, where they are what the kernel takes; of rays without bounds, where it takes bounds,
  /// copies with [0, +inf], until the next call. Error (`Usage`): they have bounds, and the kernel has none.
  Expected<RaySpan> fit(RaySpan given, bool kernelIsBounded);

private:
  std::vector<BoundedRay> copies_; ///< They only grow.
};

} // namespace voxc
