// choose-look-ahead: where construction says beforehand which nodes it will ask for.
#include "Passes.h"

namespace voxc {

/// The table of nodes that are written once is larger than caches: what is announced is near when it is
/// compared. Siblings are not compared one by one, and ranked nodes have counts that are not known
/// beforehand.
void chooseLookAhead(Plan &plan) {
  for (std::size_t i = 0; i < plan.constructions.size(); ++i) {
    const Stratum &stratum = plan.layout.strata[i];
    plan.constructions[i].looksAhead =
        plan.constructions[i].bricks && !stratum.hasRecords() && !stratum.ranked;
  }
}

} // namespace voxc
