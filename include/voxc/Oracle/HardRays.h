// Rays that are hard to trace exactly, by class, and the mixture on which kernels are verified.
#pragma once

#include "voxc/Support/Geometry.h"
#include "voxc/Trace/Ray.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace voxc {

class RandomSource;

/// One class of rays; `make` makes one for a grid of `extent` voxels.
struct HardRayClass {
  std::string_view name;
  std::string_view summary;
  Ray (*make)(RandomSource &random, Int3 extent);
  unsigned verifyShare; ///< Percent of `verifyRays`.
};

/// Every class.
std::span<const HardRayClass> hardRayClasses();

/// `count` rays of the class `className` for a grid of `extent` voxels; none if there is no such class. The
/// same arguments give the same rays on every machine.
std::vector<Ray> hardRays(Int3 extent, std::string_view className, std::size_t count, std::uint64_t seed);

/// What `voxc verify` traces: 70 % rays as of cameras and random lines, from outside and inside, and 30 %
/// axis-parallel rays and lines through lattice points, shuffled. The same arguments give the same rays.
std::vector<Ray> verifyRays(Int3 extent, std::size_t count, std::uint64_t seed);

} // namespace voxc
