// Rays, and bounds of rays, on which kernels are compared with the oracle.
#pragma once

#include "voxc/Oracle/Oracle.h"
#include "voxc/Support/Geometry.h"
#include "voxc/Trace/BoundedRay.h"
#include "voxc/Trace/Ray.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace voxc {

/// What rays are aimed at: a grid of `extent` voxels, at least one on each axis, and some or none of those
/// that are not empty. Where there are any, lattice points are every other time corners of theirs, so that
/// many rays come close to them however sparse they are.
struct RayTarget {
  Int3 extent;
  std::span<const Int3> voxels;

  /// A grid, and voxels that must stay where they are for as long as the target is used.
  RayTarget(Int3 gridExtent, std::span<const Int3> someVoxels = {})
      : extent(gridExtent), voxels(someVoxels) {}
};

/// What `voxc verify` traces: 70 % rays as of cameras and random lines, from outside and inside, and 30 %
/// axis-parallel rays and lines through lattice points, shuffled. The same arguments give the same rays on
/// every machine.
std::vector<Ray> verifyRays(const RayTarget &target, std::size_t count, std::uint64_t seed);

/// Each ray with bounds of its own: the moments, rounded to float32, at which it enters one of the first
/// voxels on it, float32 neighbours of such, moments in between, and numbers that are no moments at all. The
/// same arguments give the same bounds.
std::vector<BoundedRay> withHardBounds(const Oracle &oracle, std::span<const Ray> rays, std::uint64_t seed);

} // namespace voxc
