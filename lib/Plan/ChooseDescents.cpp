// choose-descents: what a stratum's layers leave no choice of.
#include "Passes.h"

namespace voxc {

Descent defaultDescent(const Stratum &stratum) {
  return stratum.isGrid() ? Descent::Index : stratum.depth == 0 ? Descent::Single : Descent::Stack;
}

void chooseDescents(Plan &plan) {
  for (std::size_t i = 0; i < plan.traversals.size(); ++i)
    if (plan.layout.strata[i].depth == 0)
      plan.traversals[i].descent = defaultDescent(plan.layout.strata[i]);
}

} // namespace voxc
