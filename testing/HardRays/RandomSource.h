// Random numbers that are the same on every machine: those of the rays of `voxc verify`.
#pragma once

#include "Oracle/VerifyRays/RandomSource.h"

namespace voxc::test {

using oracle::RandomSource;

} // namespace voxc::test
