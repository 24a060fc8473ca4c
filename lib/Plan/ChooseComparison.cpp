// choose-comparison: by which numbers the first of the faces ahead is found.
#include "Passes.h"

namespace voxc {

/// Bits take one instruction where others would look for NaN. Doubles have no such bits in one integer, and a
/// processor's registers have an instruction for the least of two numbers.
void chooseComparison(Plan &plan) {
  if (plan.steps == StepArithmetic::Float64 || plan.packing == Packing::Packets)
    plan.compare = Compare::Numbers;
}

} // namespace voxc
