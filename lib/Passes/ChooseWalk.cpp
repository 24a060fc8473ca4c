// Choosing the walk of all trees, or of all levels.
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

PassResult chooseLevels(Format &format, std::string_view levels, Diagnostics &diagnostics) {
  for (const Level &level : format.levels)
    if (const std::string_view walk = level.attribute(kWalkAttribute); walk != kWalkAttribute.values.front())
      diagnostics.error(level.range,
                        "this tree has walk=" + std::string(walk) +
                            ", which one loop for all levels excludes; give one of the two passes");
  const std::string_view before = format.attributes.value(kLevelsAttribute);
  if (before != levels && before != kLevelsAttribute.values.front())
    diagnostics.error({}, "the format has levels=" + std::string(before) + " already, and levels=" +
                              std::string(levels) + " excludes it; give one of the two passes");
  if (diagnostics.hasErrors())
    return PassResult::Unchanged;
  return format.setAttribute(kLevelsAttribute, levels) ? PassResult::Changed : PassResult::Unchanged;
}

} // namespace voxc
