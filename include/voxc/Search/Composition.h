// Formats as a search sees them: levels of a few shapes over the heights of a scene, and what is chosen for
// the whole. A grammar of rewrites leads from each to its neighbours, so that all are within reach of all.
#pragma once

#include "voxc/IR/Format.h"

#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// A shape that levels of compositions have.
struct LevelShape {
  char letter;                 ///< Of the kind, as in format strings.
  std::uint32_t reach = 0;     ///< Of distances.
  std::uint32_t branching = 1; ///< Of trees.
  int least = 1;               ///< log2 of the cells along an axis,
  int most = 21;               ///< inclusive.

  bool takes(int side) const {
    return side >= least && side <= most && side % static_cast<int>(branching) == 0;
  }
};

/// All of them.
std::span<const LevelShape> levelShapes();

struct ShapedLevel {
  std::size_t shape = 0; ///< Its number among `levelShapes`.
  int side = 0;          ///< log2 of its cells along an axis.

  auto operator<=>(const ShapedLevel &) const = default;
};

/// How the grids of 4^3 voxels of the last level stand, where it has such.
enum class SmallGrids {
  Pointed,   ///< As they are; words lead to them.
  Numbered,  ///< As they are, in an array; numbers of few bits lead to them.
  ByOctants, ///< The same with a byte for each octant that is not empty.
};

/// What is chosen for a whole composition, beside the passes that make any format smaller or faster.
struct FormatChoices {
  SmallGrids grids = SmallGrids::Pointed;
  std::string_view traversal; ///< One of `searchedTraversals`.

  auto operator<=>(const FormatChoices &) const = default;
};

/// Traversal passes that a search tries; the first, "", leaves it to the rule of choose-traversal.
std::span<const std::string_view> searchedTraversals();

struct Composition {
  std::vector<ShapedLevel> levels; ///< The highest first.
  FormatChoices choices;

  auto operator<=>(const Composition &) const = default;
};

/// "R(4^3) G(5)"; choices have no spelling there.
std::string toString(const Composition &composition);

/// The composition of these levels, without choices; none if a level has no shape of `levelShapes`.
std::optional<Composition> compositionOf(const Format &format);

/// Compositions of at most `maxLevels` levels that are one rewrite away, each of the same side:
/// - another shape for a level;
/// - a level split in two, one of which may have another shape;
/// - two neighbouring levels merged, in the shape of either;
/// - a height moved from a level to its neighbour, or as many as its shape takes;
/// - another choice.
std::vector<Composition> rewritesOf(const Composition &composition, std::size_t maxLevels);

/// How many heights two compositions of one side have in different shapes, or begin a level at in but one of
/// them; other small grids count as one, another traversal as several.
int differences(const Composition &a, const Composition &b);

} // namespace voxc
