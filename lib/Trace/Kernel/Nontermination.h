// Traversals that a kernel gave up, told in one way by all back ends.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Trace/Ray.h"

#include <span>

namespace voxc {

/// Error (`Input`: a check failed), with their number, if a kernel marked hits as those of traversals that
/// took more steps than a ray has cells (shaders-runtime/ray.glsl, `count_step`).
Expected<void> checkEnded(std::span<const Hit> hits);

} // namespace voxc
