// Which kernels can wait for pages.
#include "voxc/Plan/Plan.h"

#include <algorithm>

namespace voxc {

Expected<void> checkPaging(const Format &format) {
  if (format.attributes.get(kDetailAttribute) != Detail::Full)
    return Error::usage("a walk that may wait for pages stops at voxels alone: leave out --lod");
  if (questionOf(format).query == Query::Occupancy)
    return Error::usage("rays can wait for pages, but points cannot: load the whole volume to look them up");
  const auto goesItsOwnWay = [](const Level &level) {
    return level.kind->isTree() && level.get(kWalkAttribute) != Descent::Stack;
  };
  const Walk levels = format.attributes.get(kLevelsAttribute);
  if (std::ranges::any_of(format.levels, goesItsOwnWay) || (levels != Walk::Auto && levels != Walk::Direct))
    return Error::usage(
        "a walk that may wait for pages goes down from the root each time: leave out other walks");
  return {};
}

} // namespace voxc
