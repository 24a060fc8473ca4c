// choose-walk: one loop for all levels where there are many of them, and nested loops where only those can do
// what is asked.
#include "Passes.h"

#include <algorithm>

namespace voxc {
namespace {

/// Each nested level repeats the whole step. From here on that makes a kernel that takes long to compile.
constexpr std::size_t kManyLevels = 8;

} // namespace

void chooseWalk(Plan &plan) {
  const auto goesItsOwnWay = [](const Traversal &traversal) {
    return traversal.descent == Descent::Restart || traversal.descent == Descent::Unrolled;
  };
  const bool needsNesting =
      plan.detail == Detail::Cone || std::ranges::any_of(plan.traversals, goesItsOwnWay);
  if (needsNesting)
    plan.walk = Walk::Nested;
  else if (plan.layout.strata.size() >= kManyLevels)
    plan.walk = Walk::Flat;
}

} // namespace voxc
