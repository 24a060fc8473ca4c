// Open edges that lie on each other.
#pragma once

#include "Mesh/Solid/EdgeBalance.h"

#include <vector>

namespace voxc {

/// The pieces into which all ends on a line part its edges, each with how often it is passed by all of them
/// together. Pieces that even out are left out; so a corner on the edge of a neighbour, exactly, makes no
/// hole.
std::vector<RimEdge> joinedOnLines(const std::vector<RimEdge> &rims);

} // namespace voxc
