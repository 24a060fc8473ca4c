// The cubes that lead to a voxel.
#include "ScenePath.h"

#include "OctantMask.h"

#include <algorithm>
#include <bit>

namespace voxc {
namespace {

/// The place of an octant along an axis, 0 or 1.
int placeIn(unsigned octant, unsigned axis) { return static_cast<int>(octant >> axis & 1); }

} // namespace

int ScenePath::find(Int3 voxel) {
  int height = std::min(root_, std::max(found_ + 1, commonHeight(voxel, last_)));
  last_ = voxel;
  for (; height > 0; --height) {
    const SceneDag::Node node = dag_.node(height, number(height));
    const int below = height - 1;
    const auto child = static_cast<unsigned>((voxel.x >> below & 1) | (voxel.y >> below & 1) << 1 |
                                             (voxel.z >> below & 1) << 2);
    if ((node.mask >> child & 1) == 0)
      return found_ = below;
    const std::size_t before = octantsBefore(node.mask, child);
    numbers_[static_cast<std::size_t>(below)] = node.children[before];
  }
  return found_ = -1;
}

bool ScenePath::hasNothingAhead(int bottom, unsigned octant, bool byGroups) const {
  const std::array<int, 3> from = {last_.x >> bottom & 3, last_.y >> bottom & 3, last_.z >> bottom & 3};
  const auto isAhead = [&](unsigned group, unsigned cell) {
    bool ahead = true;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const int place = 2 * placeIn(group, axis) + placeIn(cell, axis);
      ahead &= placeIn(octant, axis) != 0 ? place >= from[axis] : place <= from[axis];
    }
    return ahead;
  };
  const auto isGroupAhead = [&](unsigned group) {
    bool ahead = true;
    for (unsigned axis = 0; axis < 3; ++axis)
      ahead &= placeIn(octant, axis) != 0 ? 2 * placeIn(group, axis) + 1 >= from[axis]
                                          : 2 * placeIn(group, axis) <= from[axis];
    return ahead;
  };
  const unsigned own = static_cast<unsigned>(from[0] >> 1 | (from[1] & 2) | (from[2] & 2) << 1);
  const SceneDag::Node whole = dag_.node(bottom + 2, number(bottom + 2));
  std::uint32_t groups = whole.mask;
  for (const std::uint32_t child : whole.children) {
    const auto group = static_cast<unsigned>(std::countr_zero(groups));
    groups &= groups - 1;
    if (byGroups && group != own) {
      if (isGroupAhead(group))
        return false;
      continue;
    }
    for (std::uint32_t cells = dag_.node(bottom + 1, child).mask; cells != 0; cells &= cells - 1)
      if (isAhead(group, static_cast<unsigned>(std::countr_zero(cells))))
        return false;
  }
  return true;
}

} // namespace voxc
