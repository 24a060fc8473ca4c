// Choosing the walk of all trees.
#include "ChooseWalk.h"

namespace voxc {

PassResult chooseWalk(Format &format, std::string_view walk, Diagnostics &diagnostics) {
  Format chosen = format;
  for (Level &level : chosen.levels) {
    if (level.log2Size() == Int3{}) // One cell: there is nothing to walk.
      continue;
    const std::string_view before = level.attribute(kWalkAttribute);
    if (before != walk && before != kWalkAttribute.values.front())
      diagnostics.error(level.range, "this tree has walk=" + std::string(before) + " already, and walk=" +
                                         std::string(walk) + " excludes it; give one of the two passes");
    level.setAttribute(kWalkAttribute, walk);
  }
  if (diagnostics.hasErrors() || chosen == format)
    return PassResult::Unchanged;
  format = std::move(chosen);
  return PassResult::Changed;
}

} // namespace voxc
