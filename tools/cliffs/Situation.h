// A situation in which rays are traced, drawn at random by its number: what is traced, and how.
#pragma once

#include "voxc/IR/Format.h"
#include "voxc/IR/Query.h"
#include "voxc/Support/Geometry.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace voxc::cliffs {

/// A scene in a format. Several situations share one, so that it is built once for all of them.
struct Place {
  std::uint64_t number = 0;
  std::string scene;
  Int3 extent; ///< Of the scene; the format's may be larger.
  Format format;
};

/// Between which moments rays look for voxels.
enum class Interval {
  None,    ///< The kernel knows no bounds.
  All,     ///< [0, +inf].
  Short,   ///< A few voxels from the origin on.
  Late,    ///< From shortly before the hit on.
  Slice,   ///< A few voxels somewhere on the way.
  Nothing, ///< tmax is below tmin.
};

/// The name of an interval, as reports have it.
std::string_view nameOf(Interval interval);

struct Situation {
  std::uint64_t number = 0;
  std::string rays; ///< The name of a `RayKind`.
  std::size_t count = 0;
  Query query{}; ///< The closest hit.
  Interval interval = Interval::None;
  unsigned threads = 1;
  unsigned instances = 0; ///< Of the volume in one world; 0: the rays are those of its voxels.
  bool isPaged = false;   ///< The volume comes in pages, for all of which there is room.
  std::uint64_t seed = 0; ///< Of its rays.
};

/// So many situations in a row have one place.
inline constexpr std::uint64_t kSituationsOfPlace = 8;

/// What is drawn.
struct DrawLimits {
  std::size_t mostRays = 1000000;
  int mostLog2Filled = 8; ///< log2 of the longest edge of scenes that are filled all over.
};

/// The place of the situations `number` * `kSituationsOfPlace` and on. The same for the same arguments.
Place drawPlace(std::uint64_t seed, std::uint64_t number, const DrawLimits &limits);
/// A situation there; most ask for closest hits in memory, without bounds. The same for the same arguments.
Situation drawSituation(std::uint64_t seed, std::uint64_t number, const DrawLimits &limits);

/// The format of a place as a situation asks it.
Format askedFormat(const Place &place, const Situation &situation);

/// On one line: what a reader needs to know, and what tells whether a kept case is still the same.
std::string describe(const Place &place);
std::string describe(const Situation &situation);

} // namespace voxc::cliffs
