// Distances that the cells of a sub-volume tell, found on the graph of a scene where a ray asks for one.
#pragma once

#include "voxc/Layout/Stratum.h"
#include "voxc/Search/SceneDag.h"

#include <cstddef>

namespace voxc {

/// A sub-volume of a stratum that has distances: a cube of 2^top voxels a side, by its number in the graph.
struct MeasuredCube {
  const SceneDag &dag;
  const Stratum &stratum;
  int top;
  std::size_t number;
  bool isWhole; ///< Nothing is beyond it.
};

/// What the empty cell at a place, counted in cells of the sub-volume, tells of those around it:
/// the L1 distance, or the side of the empty cube in an octant (a bit for each coordinate that rises, x
/// lowest).
int distanceAt(const MeasuredCube &cube, Int3 cell, unsigned octant);

/// The most cells from one on, itself among them, that lie in a sub-volume of `side` cells in the direction
/// of an octant, on the axis where there are least.
int cellsAhead(Int3 cell, int side, unsigned octant);

} // namespace voxc
