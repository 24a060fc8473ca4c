// Rays that are hard to trace exactly, by class, and the mixture on which kernels are verified.
#pragma once

#include "voxc/Support/Geometry.h"
#include "voxc/Trace/Ray.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace voxc::test {

class RandomSource;

/// What rays are aimed at: a grid of `extent` voxels, at least one on each axis, and some or none of those
/// that are not empty. Where there are any, lattice points are every other time corners of theirs, so that
/// many rays come close to them however sparse they are.
struct RayTarget {
  Int3 extent;
  std::span<const Int3> voxels;

  RayTarget(Int3 gridExtent, std::span<const Int3> someVoxels = {})
      : extent(gridExtent), voxels(someVoxels) {}
};

/// One class of rays; `make` makes one.
struct HardRayClass {
  std::string_view name;
  std::string_view summary;
  Ray (*make)(RandomSource &random, const RayTarget &target);
  unsigned verifyShare; ///< Percent of `verifyRays`.
};

/// Every class.
std::span<const HardRayClass> hardRayClasses();

/// `count` rays of the class `className`; none if there is no such class. The same arguments give the same
/// rays on every machine.
std::vector<Ray> hardRays(const RayTarget &target, std::string_view className, std::size_t count,
                          std::uint64_t seed);

/// What `voxc verify` traces: 70 % rays as of cameras and random lines, from outside and inside, and 30 %
/// axis-parallel rays and lines through lattice points, shuffled. The same arguments give the same rays.
std::vector<Ray> verifyRays(Int3 extent, std::size_t count, std::uint64_t seed);

} // namespace voxc::test
