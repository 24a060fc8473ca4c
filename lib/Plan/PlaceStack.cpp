// place-stack: a traversal that keeps no nodes has no stack to place.
#include "Passes.h"

#include <algorithm>

namespace voxc {
namespace {

bool keepsStack(const Plan &plan) {
  const auto keepsNodes = [](const Traversal &traversal) { return kindOf(traversal.descent).keepsNodes; };
  const LevelTraversalKind &traversal = kindOf(plan.levelTraversal);
  return traversal.keepsNodes || (traversal.nests && std::ranges::any_of(plan.traversals, keepsNodes));
}

} // namespace

void placeStack(Plan &plan) {
  if (!keepsStack(plan))
    plan.stack = Stack::Private;
}

} // namespace voxc
