// shared-stack: traversals keep the nodes above a cell in the memory that a group of rays shares.
//
// Contract: sets stack=shared on the format. The volume stays as it is, and so do the hits. Unchanged where
// no traversal keeps nodes: a direct one, or one of grids and of trees that restart or are unrolled.
#include "voxc/IR/Choices.h"
#include "voxc/IR/Stack.h"
#include "voxc/Passes/Pass.h"

#include <algorithm>

namespace voxc {

PassResult sharedStack(Format &format, Diagnostics &diagnostics) {
  const LevelTraversalKind &traversal = kindOf(format.attributes.get(kLevelsAttribute));
  const bool keeps =
      traversal.keepsNodes || (!traversal.fromRoot && std::ranges::any_of(format.levels, &Level::keepsNodes));
  if (!keeps)
    diagnostics.note({}, "no traversal of the format keeps the nodes above a cell");
  return keeps && format.setAttribute(kStackAttribute, toString(Stack::Shared)) ? PassResult::Changed
                                                                                : PassResult::Unchanged;
}

} // namespace voxc
