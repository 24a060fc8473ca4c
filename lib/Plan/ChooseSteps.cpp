// choose-steps: doubles where float32 would defer most rays to exact arithmetic, and what else tells what it
// cannot.
#include "Passes.h"

#include <algorithm>

namespace voxc {
namespace {

/// The steps of a traversal, and what float32 gets wrong of each, grow with the side: from here on more than
/// half of a camera's rays are deferred once or more, and what resolves them takes longer than doubles for
/// all.
constexpr int kLog2LongSide = 11;

} // namespace

void chooseSteps(Plan &plan) {
  const Int3 log2 = plan.layout.log2Extent();
  const bool isLong = std::max({log2.x, log2.y, log2.z}) >= kLog2LongSide;
  if (plan.isOfPoints() || !plan.isExact() || plan.arithmetic != Arithmetic::Ieee)
    return;
  if (plan.packing == Packing::Packets)
    plan.steps = StepArithmetic::Refined;
  else if (isLong)
    plan.steps = StepArithmetic::Float64;
  else
    plan.arithmetic = Arithmetic::Nearest; // For sums of two float32, which take less time than doubles.
}

} // namespace voxc
