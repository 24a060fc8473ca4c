// The generators of hard rays, one a class: each makes a ray for a grid and the voxels in it. The table of
// HardRays.cpp says what they are; the first are those of `voxc verify`.
#pragma once

#include "testing/HardRays.h"

#include "Oracle/VerifyRays/RayKinds.h"

namespace voxc::test {

using namespace oracle;

Ray cornerRay(RandomSource &random, const RayTarget &target);
Ray wholeRay(RandomSource &random, const RayTarget &target);
Ray touchRay(RandomSource &random, const RayTarget &target);
Ray boundaryUlpRay(RandomSource &random, const RayTarget &target);
Ray grazingRay(RandomSource &random, const RayTarget &target);
Ray grazingMeetRay(RandomSource &random, const RayTarget &target);
Ray tunnelRay(RandomSource &random, const RayTarget &target);
Ray nearTieRay(RandomSource &random, const RayTarget &target);
Ray nearLatticeRay(RandomSource &random, const RayTarget &target);
Ray exactTieRay(RandomSource &random, const RayTarget &target);
Ray brokenTieRay(RandomSource &random, const RayTarget &target);
Ray tinyRay(RandomSource &random, const RayTarget &target);
Ray scaledRay(RandomSource &random, const RayTarget &target);
Ray mixedRay(RandomSource &random, const RayTarget &target);
Ray farRay(RandomSource &random, const RayTarget &target);
Ray farthestRay(RandomSource &random, const RayTarget &target);
Ray retreatRay(RandomSource &random, const RayTarget &target);
Ray largeRay(RandomSource &random, const RayTarget &target);
Ray hugeRay(RandomSource &random, const RayTarget &target);
Ray onBoundaryRay(RandomSource &random, const RayTarget &target);
Ray solidRay(RandomSource &random, const RayTarget &target);
Ray farFaceRay(RandomSource &random, const RayTarget &target);
Ray signedZeroRay(RandomSource &random, const RayTarget &target);
Ray stillRay(RandomSource &random, const RayTarget &target);
Ray notFiniteRay(RandomSource &random, const RayTarget &target);

} // namespace voxc::test
