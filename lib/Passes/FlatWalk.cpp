// flat-walk: one loop through the nodes of all levels, in place of a loop for each.
//
// Contract: sets levels=flat on the format. The volume stays as it is, and so do the hits. An error where a
// tree restarts or is unrolled: the loop has a stack of its own.
#include "voxc/Passes/Pass.h"

namespace voxc {

PassResult flatWalk(Format &format, Diagnostics &diagnostics) {
  for (const Level &level : format.levels)
    if (const std::string_view walk = level.attribute(kWalkAttribute); walk != kWalkAttribute.values.front())
      diagnostics.error(level.range,
                        "this tree has walk=" + std::string(walk) +
                            ", which one loop for all levels excludes; give one of the two passes");
  if (diagnostics.hasErrors())
    return PassResult::Unchanged;
  return format.setAttribute(kLevelsAttribute, "flat") ? PassResult::Changed : PassResult::Unchanged;
}

} // namespace voxc
