// The exact hit, by its definition in docs/ir.md: slow, simple, and sharing no code with the kernels.
#pragma once

#include "voxc/IR/Query.h"
#include "voxc/Source/VoxelSource.h"
#include "voxc/Trace/BoundedRay.h"
#include "voxc/Volume/Volume.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace voxc {

/// The face of a voxel by which a ray enters it.
struct Face {
  int axis = -1; ///< 0, 1, 2 for x, y, z; -1: none, for the ray starts in the voxel.
  int side = 0;  ///< -1: the voxel's low face, by which a rising ray enters; 1: its high face.

  bool operator==(const Face &) const = default;
};

/// A face as hits have it: twice its axis, and 1 more for the high one; 6 for none.
std::uint32_t faceNumber(const Face &face);

/// A ray's hit with its reasons.
struct Explanation {
  Hit hit; ///< As `Oracle::trace` gives it.
  /// Where it enters the voxel; none for a miss. Of several faces that are crossed at that very moment, as at
  /// an edge or a corner, that of the first axis.
  Face face;
  /// The ray's cells within the extent, in order: from where it enters the extent, or starts, to the voxel
  /// that is hit, inclusive, or to where it leaves.
  std::vector<Int3> cells;
  bool complete = true; ///< False if there are more cells than were asked for.
};

/// Evaluates the definition of a hit in exact arithmetic on decoded voxels. Memory follows the voxels: 12
/// bytes for each run of equal ones in Morton order, and about as much for the tree of empty cells. All
/// queries may be made by several threads at once.
class Oracle {
public:
  /// Decodes `volume` into runs of its own. Errors: as `decode`; more runs than can be kept.
  static Expected<Oracle> of(const Volume &volume, const Progress &progress = {});
  /// Reads `source` to its end: the oracle of every volume that is built from it, whatever the format.
  /// Errors: that of a source that fails; interrupted; more runs than can be kept.
  static Expected<Oracle> of(VoxelSource &source, const Progress &progress = {});
  ~Oracle();
  Oracle(Oracle &&) noexcept;

  /// The hit of `ray`, the first of those that it enters between the bounds; t is the exact value rounded to
  /// float32 (`steps` is 0).
  Hit trace(const Ray &ray, const RayBounds &bounds = {}) const;

  /// What a kernel that is asked `question` stores of `ray`, to the bit: the hit, with 0 where it is asked
  /// less.
  Hit answer(const Ray &ray, const Question &question, const RayBounds &bounds = {}) const;

  /// The hits of many rays, hits[i] that of rays[i], on so many threads (0: as many as the machine has).
  /// Error: interrupted.
  Expected<std::vector<Hit>> trace(RaySpan rays, unsigned threads = 0, const Progress &progress = {}) const;

  /// The hit of `ray` between the bounds, the face by which it is entered, and the first `maxCells` cells on
  /// the way to the first that is not empty, whatever the bounds.
  Explanation explain(const Ray &ray, std::size_t maxCells, const RayBounds &bounds = {}) const;

  /// Some of the voxels that are not empty: at most `count`, spread evenly over their runs in Morton order.
  std::vector<Int3> sampleVoxels(std::size_t count) const;

  /// The word of a voxel; 0 outside.
  std::uint32_t voxel(Int3 cell) const;

private:
  struct State;
  explicit Oracle(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// How far hits are from the oracle's, and the first rays on which they differ.
struct ErrorFigures {
  std::uint64_t rays = 0;
  std::uint64_t missed = 0; ///< The oracle hits, the kernel does not.
  std::uint64_t ghost = 0;  ///< The kernel hits, the oracle does not.
  std::uint64_t wrong = 0;  ///< Another voxel, or another of its faces.
  std::uint64_t colour = 0; ///< The right voxel with another word.
  /// Of missed, ghost and wrong: those that rounding at a cell's boundary explains. Let e be 2^-20 times the
  /// largest of 1, the origin's coordinates and those of the voxels at stake (16 half-ulps of float32 there).
  /// A difference on a finite ray is explained if the two voxels are neighbours, one cell apart at most on
  /// each axis. Or else it is if these two hold:
  /// - the kernel's voxel, if it hits, is not empty, and the ray meets its cell grown by e on every side;
  /// - the oracle's voxel, if it hits, is met no sooner than the kernel's, both grown by e; or else its cell
  ///   shrunk by e on every side is not met at all: the kernel may have passed it by.
  /// Nothing explains the hit of a kernel that does not report its voxel.
  std::uint64_t boundary = 0;
  std::uint64_t sameVoxel = 0; ///< Rays on which both hit the same voxel: those that have a dt.
  double maxDt = 0;            ///< In voxels: t times the direction's length, where both hit the same voxel.
  double rmsDt = 0;
  double maxUlpDt = 0; ///< In units in the last place of the oracle's t. A t beyond float32 counts as 2^128.
  std::uint64_t latest = 0;            ///< Index of the first ray with `maxUlpDt`.
  std::vector<std::uint64_t> examples; ///< Indices of the first rays that differ, at most 16.

  /// Rays on which the kernel is not right.
  std::uint64_t differences() const { return missed + ghost + wrong + colour; }
  bool clean() const { return differences() == 0; }
  /// Adds the figures of further rays, whose indices go on where these end.
  void append(const ErrorFigures &further);
};

/// Compares hits with the oracle's, in what is asked of them: hits[i] is that of rays[i], and there are as
/// many. On all threads.
ErrorFigures compare(const Oracle &oracle, RaySpan rays, std::span<const Hit> hits,
                     const Question &question = {});

/// The same with the oracle's hits at hand: exact[i] is that of rays[i], whatever is asked. They depend on
/// nothing but voxels and rays, so that one `Oracle::trace` serves every format, traversal and device.
ErrorFigures compare(const Oracle &oracle, RaySpan rays, std::span<const Hit> exact,
                     std::span<const Hit> hits, const Question &question = {});

} // namespace voxc
