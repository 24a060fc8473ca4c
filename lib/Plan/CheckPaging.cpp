// Which kernels can wait for pages.
#include "voxc/Plan/Plan.h"

#include <algorithm>

namespace voxc {

Expected<void> checkPaging(const Format &format) {
  if (format.attributes.value(kDetailAttribute) != "full")
    return Error::usage("a walk that may wait for pages stops at voxels alone: leave out --lod");
  if (questionOf(format).query == Query::Occupancy)
    return Error::usage("rays can wait for pages, but points cannot: load the whole volume to look them up");
  const auto goesItsOwnWay = [](const Level &level) {
    return level.kind->isTree() && level.attribute(kWalkAttribute) != "stack";
  };
  const std::string_view levels = format.attributes.value(kLevelsAttribute);
  if (std::ranges::any_of(format.levels, goesItsOwnWay) || (levels != "auto" && levels != "direct"))
    return Error::usage(
        "a walk that may wait for pages goes down from the root each time: leave out other walks");
  return {};
}

} // namespace voxc
