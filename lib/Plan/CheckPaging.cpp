// Which kernels can wait for pages.
#include "voxc/Plan/Plan.h"

#include <algorithm>

namespace voxc {

Expected<void> checkPaging(const Format &format) {
  const Plan plan = lowerToPlan(format);
  if (plan.stopsAboveVoxels())
    return Error::usage("a traversal that may wait for pages stops at voxels alone: leave out --lod");
  if (plan.isOfPoints())
    return Error::usage("rays can wait for pages, but points cannot: load the whole volume to look them up");
  const LevelTraversalKind &traversal = kindOf(plan.levelTraversal);
  const bool nests = std::ranges::any_of(
      plan.traversals, [](const Traversal &traversal) { return kindOf(traversal.descent).nestsAlone; });
  if (nests || !(traversal.isOpen || traversal.fromRoot))
    return Error::usage(
        "a traversal that may wait for pages goes down from the root each time: leave out other traversals");
  return {};
}

} // namespace voxc
