// The table of level kinds: each base format is described once, in lib/Level, and everything draws from it.
#pragma once

#include "voxc/IR/Attribute.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace voxc {

struct Level;
class WordReader;
class SubVolumeVisitor;
struct Lookup;
struct Int3;

/// What a parameter of a level means.
enum class ParameterRole {
  Width,  ///< log2 of the cells along x.
  Height, ///< log2 of the cells along y.
  Depth,  ///< log2 of the cells along z.
  Side,   ///< log2 of the cells along each axis.
  Reach,  ///< the largest distance stored.
};

struct ParameterKind {
  std::string_view name; ///< As in the grammar: "W", "L", "M".
  ParameterRole role;
  std::string_view meaning; ///< For documentation and diagnostics.
};

/// How a level arranges its cells: decides which families of walks and constructions apply.
enum class Arrangement {
  Grid, ///< An array of cells.
  Tree, ///< An octree of nodes.
};

/// One base format. Adding one: a file in lib/Level, its row in lib/Level/LevelKinds.cpp, and its leaves in
/// shaders-runtime/level and construct-runtime/level.
struct LevelKind {
  char letter;               ///< In format strings: 'R'.
  std::string_view name;     ///< In IR text, and of its runtime files: "raw".
  std::string_view longName; ///< What people write by mistake: "Raw".
  std::string_view summary;
  Arrangement arrangement;
  std::uint32_t wordsPerCell; ///< Of a grid; 0 for trees.
  std::span<const ParameterKind> parameters;
  std::span<const AttributeKind *const> attributes;

  /// The terminating integer of `cell` in the sub-volume at `offset`, and the empty or uniform cube around
  /// it.
  Lookup (*lookup)(const WordReader &words, const Level &level, std::uint32_t offset, Int3 cell);

  /// Visits the sub-volume at `offset` and its non-empty cells in Morton order, checking every word on the
  /// way.
  void (*walk)(WordReader &words, const Level &level, std::uint32_t offset, SubVolumeVisitor &visitor);

  /// Replaces every pointer p among words that construction wrote at once (a grid, a node, a block of
  /// siblings) by `newOffsets[p]`. `holdsVoxels`: terminating integers of this level are voxels. False if one
  /// leads to no offset, or to 0.
  bool (*relocate)(std::span<std::uint32_t> words, bool holdsVoxels,
                   std::span<const std::uint32_t> newOffsets);
};

/// All level kinds, in the order of the documentation.
std::span<const LevelKind *const> levelKinds();

/// The kind with this letter (or IR name), or null.
const LevelKind *findLevelKind(char letter);
const LevelKind *findLevelKind(std::string_view name);

} // namespace voxc
