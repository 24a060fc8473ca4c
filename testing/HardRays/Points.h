// What the classes of hard rays are made of: the points and lines of the rays of `voxc verify`, and numbers.
#pragma once

#include "testing/HardRays.h"

#include "Oracle/VerifyRays/Points.h"

namespace voxc::test {

using namespace oracle;

/// Plus or minus 2^e, e in [low, high].
float signedPower(RandomSource &random, int low, int high);
/// A number in [0.5, 1) times 2^e, e in [low, high].
double scaledReal(RandomSource &random, int low, int high);
/// The value, or a float32 next to it.
float nudged(RandomSource &random, float value);

} // namespace voxc::test
