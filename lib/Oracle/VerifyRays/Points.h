// Points, directions and lines that rays are made of.
#pragma once

#include "RandomSource.h"

#include "voxc/Oracle/VerifyRays.h"

namespace voxc::oracle {

using Point = float[3];

/// A ray from `point` - `steps` * `direction`: exact for small integers and halves.
Ray backedOff(const Point &point, const Point &direction, float steps);
/// A ray from `origin` towards `aim`, which it reaches at about t = 1.
Ray between(const Point &origin, const Point &aim);

/// A point of the grid grown on each side by `reach` of its extent.
void randomPoint(RandomSource &random, const RayTarget &target, Point &point, double reach = 0);
/// A corner of a cell; every other time one of a voxel of the target, if it has any.
void latticePoint(RandomSource &random, const RayTarget &target, Point &point);
/// A cell of the grid; every other time one of the target's voxels, if it has any.
Int3 randomCell(RandomSource &random, const RayTarget &target);
/// Whole components from -`most` to `most`, not all of them zero.
void wholeDirection(RandomSource &random, Point &direction, int most = 3);

/// Along an axis, with `onLattice` of the two other coordinates whole and the rest at a cell's centre.
Ray axisParallel(RandomSource &random, const RayTarget &target, int onLattice);

} // namespace voxc::oracle
