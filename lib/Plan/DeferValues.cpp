// defer-values: when the value of a voxel is looked up.
#include "Passes.h"

namespace voxc {

/// A traversal that stops at voxels alone needs one value at its end. One that stops above them too hands on
/// a colour from wherever it stops, so that each stop has its own.
void deferValues(Plan &plan) {
  if (plan.stopsAboveVoxels() && storesValue(plan.outputs))
    plan.defersValues = false;
}

} // namespace voxc
