// Rays that are hard to trace exactly, by class.
#pragma once

#include "voxc/Oracle/VerifyRays.h"
#include "voxc/Trace/Ray.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace voxc::oracle {

class RandomSource;

} // namespace voxc::oracle

namespace voxc::test {

using oracle::RandomSource;

/// One class of rays; `make` makes one.
struct HardRayClass {
  std::string_view name;
  std::string_view summary;
  Ray (*make)(RandomSource &random, const RayTarget &target);
};

/// Every class.
std::span<const HardRayClass> hardRayClasses();

/// `count` rays of the class `className`; none if there is no such class. The same arguments give the same
/// rays on every machine.
std::vector<Ray> hardRays(const RayTarget &target, std::string_view className, std::size_t count,
                          std::uint64_t seed);

} // namespace voxc::test
