// Rays as a kernel takes them: with bounds or without.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Trace/BoundedRay.h"

#include <vector>

namespace voxc {

class FittingRays {
public:
  /// The given rays, where they are what the kernel takes; of rays without bounds, where it takes bounds,
  /// copies with [0, +inf]. Error (`Usage`): they have bounds, and the kernel has none.
  static Expected<FittingRays> of(RaySpan given, bool kernelIsBounded);

  RaySpan rays() const { return copies_.empty() ? given_ : RaySpan(copies_); }

private:
  explicit FittingRays(RaySpan given) : given_(given) {}

  RaySpan given_;
  std::vector<BoundedRay> copies_;
};

} // namespace voxc
