// A tracer before another, that hands it the rays in an order in which they are traced faster.
#pragma once

#include "voxc/Trace/Tracer.h"

#include <memory>

namespace voxc {

/// Traces as `tracer` does, through `volume`, in the order that `TraceOptions::order` says. The seconds that
/// ordering takes are in each repeat's times. It is done by so many threads; 0: as many as the machine runs.
/// `pays`: whether `RayOrder::Auto` may choose bins, as tracing takes longer than ordering.
std::unique_ptr<Tracer> inOrder(std::unique_ptr<Tracer> tracer, const Volume &volume, unsigned threads,
                                bool pays);

} // namespace voxc
