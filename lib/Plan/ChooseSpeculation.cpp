// choose-speculation: whether a traversal goes on before it is known if its last step was sure.
#include "Passes.h"

namespace voxc {

/// Each turn of a direct traversal begins with a read that waits for the cell: the next one can be under way
/// while the step's error is still being looked at. Nested and flat traversals have other things to ask in
/// between.
void chooseSpeculation(Plan &plan) {
  plan.speculative = kindOf(plan.levelTraversal).fromRoot && plan.isExact();
}

} // namespace voxc
