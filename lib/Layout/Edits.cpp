// What of a layout stands against edits.
#include "voxc/Layout/Edits.h"

#include "voxc/Layout/SlotKind.h"

namespace voxc {

std::string whyNoEdits(const Layout &layout) {
  if (layout.ranksVoxels())
    return "values stand apart from the levels, by their place among all voxels, and an edit would move "
           "those of every voxel behind it; a build without values-apart can be edited";
  for (std::size_t i = 0; i < layout.strata.size(); ++i)
    if (const std::string_view reason = layout.strata[i].slots->forbidsEdits; !reason.empty())
      return "level " + std::to_string(i + 1) + " " + std::string(reason) +
             "; a build without this can be edited";
  return {};
}

} // namespace voxc
