// Choices of how a kernel goes through a format: what attributes of the level IR and fields of a plan both
// say.
#pragma once

#include "voxc/Support/EnumText.h"

#include <cstddef>

namespace voxc {

/// How a kernel goes from level to level.
enum class LevelTraversal {
  Auto,   ///< Not chosen yet: the pass choose-traversal does.
  Nested, ///< A loop for each level, which calls that of the next.
  Flat,   ///< One loop through the nodes of all levels: a kernel of one step, however many levels there are.
  Direct, ///< One loop whose every turn goes down from the root through all levels, without a loop in it.
};

/// How the traversal of a stratum finds the cell around a point. Each value is a file of
/// shaders-runtime/traversal.
enum class Descent {
  Index,    ///< In the one node of a grid, by the cell's number.
  Single,   ///< The sub-volume is one cell.
  Stack,    ///< Down a tree from the common ancestor of this cell and the last, kept in a stack.
  Restart,  ///< Down a tree from its root, each time.
  Unrolled, ///< Down a tree by a function for each layer, each with a loop over the children of a node.
};

/// Which hits the kernel gives: which arithmetic orders the faces that a ray crosses. Each value is a file of
/// shaders-runtime/step.
enum class Precision {
  Exact, ///< Float32 where its error bound decides, integers elsewhere: the exact hit for every ray.
  Fast,  ///< Plain float32: wrong only by rounding at a boundary.
};

/// Where a traversal may stop.
enum class Detail {
  Full, ///< At voxels.
  Cone, ///< Also at a node or a cell that looks smaller than a cone around the ray is wide.
};

/// What there is to know of a way from level to level.
struct LevelTraversalKind {
  bool isOpen = false;     ///< It is still to be chosen.
  bool nests = false;      ///< Each level has a loop, in which that of the next is called.
  bool isOneLoop = false;  ///< For all levels, which go down trees in its way.
  bool fromRoot = false;   ///< Each turn goes down from the root.
  bool keepsNodes = false; ///< Those above the current cell, whatever the levels are.
};

/// The same of the way to a cell.
struct DescentKind {
  bool ofGrids = false;    ///< Of one node, whose cells have numbers.
  bool ofCells = false;    ///< Of sub-volumes that are one cell.
  bool keepsNodes = false; ///< Those above the current cell.
  bool restarts = false;   ///< At the root of the sub-volume, each time.
  bool byLayers = false;   ///< By a function for each.
  bool nestsAlone = false; ///< Only a traversal that nests can have it.
};

/// In the order of `LevelTraversal`.
inline constexpr std::array<LevelTraversalKind, 4> kLevelTraversalKinds = {
    {{.isOpen = true},
     {.nests = true},
     {.isOneLoop = true, .keepsNodes = true},
     {.isOneLoop = true, .fromRoot = true}}};

/// In the order of `Descent`.
inline constexpr std::array<DescentKind, 5> kDescentKinds = {{{.ofGrids = true},
                                                              {.ofCells = true},
                                                              {.keepsNodes = true},
                                                              {.restarts = true, .nestsAlone = true},
                                                              {.byLayers = true, .nestsAlone = true}}};

constexpr const LevelTraversalKind &kindOf(LevelTraversal traversal) {
  return kLevelTraversalKinds[static_cast<std::size_t>(traversal)];
}
constexpr const DescentKind &kindOf(Descent descent) {
  return kDescentKinds[static_cast<std::size_t>(descent)];
}

template <>
inline constexpr std::array<std::string_view, 5> kEnumNames<Descent> = {"index", "single", "stack", "restart",
                                                                        "unrolled"};
template <>
inline constexpr std::array<std::string_view, 4> kEnumNames<LevelTraversal> = {"auto", "nested", "flat",
                                                                               "direct"};
template <> inline constexpr std::array<std::string_view, 2> kEnumNames<Precision> = {"exact", "fast"};
template <> inline constexpr std::array<std::string_view, 2> kEnumNames<Detail> = {"full", "cone"};

} // namespace voxc
