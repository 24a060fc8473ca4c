// choose-span-faces: where a direct traversal makes the faces ahead of what it finds empty.
#include "Passes.h"

namespace voxc {

/// A device has time for it in each look-up, while that waits for what it reads. In packets what counts is
/// how much is done, and not how long a turn waits: there it is done once for all levels.
void chooseSpanFaces(Plan &plan) {
  if (kindOf(plan.levelTraversal).fromRoot && plan.packing == Packing::Device)
    plan.spanFaces = SpanFaces::Lookup;
}

} // namespace voxc
