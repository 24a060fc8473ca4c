// Rays as a kernel takes them.
#include "FittingRays.h"

namespace voxc {

Expected<FittingRays> FittingRays::of(RaySpan given, bool kernelIsBounded) {
  if (given.isBounded() && !kernelIsBounded)
    return Error::usage(
        "the rays have bounds, but the kernel was compiled for rays without: compile one with bounds=yes");
  FittingRays fitting(given);
  if (given.isBounded() == kernelIsBounded)
    return fitting;
  fitting.copies_.reserve(given.size());
  for (std::size_t i = 0; i < given.size(); ++i)
    fitting.copies_.push_back(bounded(given[i]));
  if (given.empty())
    fitting.given_ = std::span<const BoundedRay>();
  return fitting;
}

} // namespace voxc
