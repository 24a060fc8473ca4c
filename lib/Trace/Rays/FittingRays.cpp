// Rays as a kernel takes them.
#include "FittingRays.h"

namespace voxc {

Expected<RaySpan> FittingRays::fit(RaySpan given, bool kernelIsBounded) {
  if (given.isBounded() && !kernelIsBounded)
    return Error::usage(
        "the rays have bounds, but the kernel was compiled for rays without: compile one with bounds=yes");
  if (given.isBounded() == kernelIsBounded)
    return given;
  if (given.size() > copies_.size())
    copies_.resize(given.size());
  for (std::size_t i = 0; i < given.size(); ++i)
    copies_[i] = bounded(given[i]);
  return RaySpan(std::span<const BoundedRay>(copies_).first(given.size()));
}

} // namespace voxc
