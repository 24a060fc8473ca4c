// A tracer that can be ended soon, around one that goes on to the end of what it has begun.
#pragma once

#include "voxc/Trace/Tracer.h"

#include <memory>

namespace voxc::view {

/// Hands rays on in slices that take about `seconds` each, and looks between them whether to stop. A device
/// takes what it was given in one piece, which may be long where it is slow. Its report tells of one repeat.
std::unique_ptr<Tracer> inSlices(std::unique_ptr<Tracer> tracer, double seconds);

} // namespace voxc::view
