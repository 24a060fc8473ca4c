// Rims of holes as loops that pass no corner twice.
#pragma once

#include "Mesh/Solid/EdgeBalance.h"

#include <span>
#include <vector>

namespace voxc {

/// An edge as a loop passes it.
struct LoopEdge {
  glm::dvec3 from{}; ///< In model units.
  glm::dvec3 to{};
};

/// Parts edges into loops, as many times as each is passed; or, if `isEither`, those that are passed an odd
/// number of times, once, whichever way. Short ways back are gone first, so that cracks are loops of their
/// own. Nothing, if there are 2^20 edges or more, or if they make no loops.
std::vector<std::vector<LoopEdge>> loopsOf(std::span<const RimEdge> rims, bool isEither);

} // namespace voxc
