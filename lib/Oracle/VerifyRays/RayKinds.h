// The kinds of rays that `voxc verify` traces: each makes a ray for a grid and the voxels in it.
#pragma once

#include "RandomSource.h"

#include "voxc/Oracle/VerifyRays.h"

namespace voxc::oracle {

/// As a camera's: a direction of unit length, from the outside.
Ray cameraRay(RandomSource &random, const RayTarget &target);
/// A line of chance that starts outside the grid, or inside it.
Ray outsideRay(RandomSource &random, const RayTarget &target);
Ray insideRay(RandomSource &random, const RayTarget &target);
/// Parallel to an axis: through the centres of cells, in a plane between cells, and along edges of cells.
Ray axisCentreRay(RandomSource &random, const RayTarget &target);
Ray axisFaceRay(RandomSource &random, const RayTarget &target);
Ray axisEdgeRay(RandomSource &random, const RayTarget &target);
/// Through lattice points along small whole directions.
Ray diagonalRay(RandomSource &random, const RayTarget &target);

} // namespace voxc::oracle
