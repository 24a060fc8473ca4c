// Places of children within a node: how they are numbered, and Morton order over them.
#pragma once

#include "voxc/Layout/SlotKind.h"

#include <cstdint>

namespace voxc {

/// The number of a cell of a grid: x fastest, then y, then z.
inline std::uint64_t gridIndex(Int3 log2Shape, Int3 place) {
  return static_cast<std::uint64_t>(place.x) +
         ((static_cast<std::uint64_t>(place.y) + (static_cast<std::uint64_t>(place.z) << log2Shape.y))
          << log2Shape.x);
}

/// The number of a child by which its node's masks and slots go: that of a grid, or Morton order in trees.
inline std::uint64_t childIndex(const Stratum &stratum, Int3 place) {
  return stratum.isGrid() ? gridIndex(stratum.log2Shape, place) : mortonCode(place);
}

/// Visits the places of a node in Morton order; aligned cubes outside its shape are never entered.
template <typename Visit> void forEachPlace(Int3 log2Shape, Int3 low, int log2Side, Visit &&visit) {
  for (int axis = 0; axis < 3; ++axis)
    if (low[axis] >> log2Shape[axis] != 0)
      return;
  if (log2Side == 0)
    return visit(low);
  for (int child = 0; child < 8; ++child)
    forEachPlace(log2Shape, low + Int3{child & 1, child >> 1 & 1, child >> 2} * (1 << (log2Side - 1)),
                 log2Side - 1, visit);
}

template <typename Visit> void forEachPlace(const Stratum &stratum, Visit &&visit) {
  forEachPlace(stratum.log2Shape, {}, maxComponent(stratum.log2Shape), visit);
}

/// Replaces a reference by its new place. False if there is none.
inline bool relocateRef(std::uint32_t &ref, Relocation relocation) {
  ref = relocation(ref);
  return ref != 0;
}

} // namespace voxc
