// choose-speculation: whether a walk goes on before it is known if its last step was sure.
#include "Passes.h"

namespace voxc {

/// Each turn of a direct walk begins with a read that waits for the cell: the next one can be under way while
/// the step's error is still being looked at. Nested and flat walks have other things to ask in between.
void chooseSpeculation(Plan &plan) { plan.speculative = kindOf(plan.walk).fromRoot && plan.isExact(); }

} // namespace voxc
