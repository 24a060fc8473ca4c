// The exact hit, by definition (contract, section 6): slow, simple, and sharing no code with the kernels.
#pragma once

#include "voxc/Trace/Ray.h"
#include "voxc/Volume/Volume.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace voxc {

/// Evaluates the definition of a hit in exact arithmetic on decoded voxels.
class Oracle {
public:
  /// Decodes `volume` into runs of its own. Errors: as `decode`; more uniform cubes than can be kept.
  static Expected<Oracle> of(const Volume &volume, const Progress &progress = {});
  ~Oracle();
  Oracle(Oracle &&) noexcept;

  /// The hit of `ray`; t is the exact value rounded to float32 (`steps` is 0).
  Hit trace(const Ray &ray) const;

  /// The word of a voxel; 0 outside.
  std::uint32_t voxel(Int3 cell) const;

private:
  struct State;
  explicit Oracle(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// How far hits are from the oracle's (contract, section 6), and the first rays on which they differ.
struct ErrorFigures {
  std::uint64_t rays = 0;
  std::uint64_t missed = 0; ///< The oracle hits, the kernel does not.
  std::uint64_t ghost = 0;  ///< The kernel hits, the oracle does not.
  std::uint64_t wrong = 0;  ///< Another voxel.
  std::uint64_t colour = 0; ///< The right voxel with another word.
  /// Of missed, ghost and wrong: those that rounding at a cell's boundary explains. Let e be 2^-20 times the
  /// largest of 1, the origin's coordinates and those of the voxels at stake (16 half-ulps of float32 there).
  /// A difference on a finite ray is explained if the two voxels are neighbours, one cell apart at most on
  /// each axis. Or else it is if these two hold:
  /// - the kernel's voxel, if it hits, is not empty, and the ray meets its cell grown by e on every side;
  /// - the oracle's voxel, if it hits, is met no sooner than the kernel's, both grown by e; or else its cell
  ///   shrunk by e on every side is not met at all: the kernel may have passed it by.
  std::uint64_t boundary = 0;
  double maxDt = 0; ///< In voxels: t times the direction's length, where both hit the same voxel.
  double rmsDt = 0;
  double maxUlpDt = 0; ///< In units in the last place of the oracle's t. A t beyond float32 counts as 2^128.
  std::vector<std::uint64_t> examples; ///< Indices of the first rays that differ, at most 16.

  bool clean() const { return missed == 0 && ghost == 0 && wrong == 0 && colour == 0; }
};

/// Compares hits with the oracle's: hits[i] is that of rays[i], and there are as many.
ErrorFigures compare(const Oracle &oracle, std::span<const Ray> rays, std::span<const Hit> hits);

} // namespace voxc
