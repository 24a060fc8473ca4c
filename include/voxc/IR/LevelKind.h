// The table of level kinds: each base format is described once, in lib/IR/Levels, and everything draws from
// it.
#pragma once

#include "voxc/IR/Attribute.h"
#include "voxc/Layout/Stratum.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace voxc {

struct Level;

/// What a parameter of a level means.
enum class ParameterRole {
  Width,     ///< log2 of the cells along x.
  Height,    ///< log2 of the cells along y.
  Depth,     ///< log2 of the cells along z.
  Side,      ///< log2 of the cells along each axis.
  Reach,     ///< the largest distance stored.
  Branching, ///< log2 of the children of a node along each axis.
};

struct ParameterKind {
  std::string_view name; ///< As in the grammar: "W", "L", "M".
  ParameterRole role;
  std::string_view meaning; ///< For documentation and diagnostics.
  std::uint32_t least = 0;  ///< The values that it takes,
  std::uint32_t most = 0;   ///< inclusive.
  std::optional<std::uint32_t>
      defaultValue; ///< What it is if it is not written; only the last parameters may be so.

  bool isSize() const { return role != ParameterRole::Reach && role != ParameterRole::Branching; }
};

/// One base format. Adding one: a file in lib/IR/Levels and its row in LevelKinds.cpp there; where its nodes
/// keep their children as no other kind's do, a slot kind too (include/voxc/Layout/SlotKind.h).
struct LevelKind {
  char letter;               ///< In format strings: 'R'.
  std::string_view name;     ///< In IR text: "raw".
  std::string_view longName; ///< What people write by mistake: "Raw".
  std::string_view summary;
  std::span<const ParameterKind> parameters;
  std::span<const AttributeKind *const> attributes;

  /// How a level of this kind lies in words; the caller sets what depends on other levels (`log2Cell`, and
  /// what `Layout::complete` does) and on no kind (`level`).
  Stratum (*lower)(const Level &level);

  /// What the level asks of the one above, whose slots lead to its sub-volumes, null if it is the first; what
  /// that makes of itself, too. Returns what is wrong, to follow "level 2", or "". Null: it asks nothing.
  std::string (*lead)(const Level &level, Stratum &own, Stratum *above) = nullptr;

  /// True for trees, which have one size for all axes.
  bool isTree() const;
};

/// All level kinds, in the order of the documentation.
std::span<const LevelKind *const> levelKinds();

/// The kind with this letter (or IR name), or null.
const LevelKind *findLevelKind(char letter);
const LevelKind *findLevelKind(std::string_view name);

} // namespace voxc
