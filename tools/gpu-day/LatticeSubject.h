// Kernels on billions of hard rays, against a program that finds exact hits by integers alone (lattice.comp).
#pragma once

#include "KernelSubject.h"

namespace voxc::gpu {

/// The programs that draw rays with their exact hits, and compare: SPIR-V of lattice.comp and compare.comp.
struct LatticePrograms {
  std::span<const std::uint32_t> lattice, compare;
};

struct LatticeOptions {
  std::uint64_t rays = std::uint64_t{1} << 24; ///< In all, rounded up to whole batches.
  std::uint32_t seed = 1;
  double seconds = 0; ///< Ends after the batch in which so much time has passed; 0: never before all rays.
};

/// Draws rays, traces them by the kernel in two dispatches, and compares every hit, all on the device: how
/// many rays, hits and differences there were, and an example of these with its ray. Errors: a volume whose
/// sides are no more than 128 voxels is asked for (`Input`); those of the device.
Expected<tool::Json> checkLattice(const Gpu &gpu, const Volume &volume, const Kernel &kernel,
                                  const LatticePrograms &programs, const LatticeOptions &options);

} // namespace voxc::gpu
