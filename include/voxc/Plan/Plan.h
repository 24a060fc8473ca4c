// The plan: what each level loads, how it descends, how it steps and which predicate decides. Every text that
// voxc generates is printed from it; no emitter looks at a choice that is not written here.
#pragma once

#include "voxc/IR/Format.h"
#include "voxc/Trace/Kernel.h"

#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// How the walk of a level finds the cell around a point. Each value is a file of shaders-runtime/walk.
enum class Descent {
  Index,    ///< Arithmetic on the cell's coordinates: a grid.
  Distance, ///< The same, and the cell's distance allows several steps without a lookup.
  Single,   ///< The sub-volume is one cell: a tree of depth 0.
  Stack,    ///< Down a tree from the common ancestor of this cell and the last, kept in a stack.
  Restart,  ///< Down a tree from its root, each time.
  Unrolled, ///< Down a tree by a function for each height, each with a loop over the children of a node.
};

/// Which arithmetic orders the faces that a ray crosses. Each value is a file of shaders-runtime/step.
enum class Predicate {
  Exact,   ///< Float32 where its error bound decides, integers elsewhere: the exact hit for every ray.
  Float32, ///< Plain float32: wrong only by rounding at a boundary.
};

/// Where a walk may stop.
enum class Detail {
  Full, ///< At voxels.
  Cone, ///< Also at a node or a cell that looks smaller than a cone around the ray is wide.
};

/// Which nodes of a tree, or whole grids, may be shared when they are built.
enum class Sharing {
  None,      ///< Nothing is looked up: an octree, or grids as they come.
  SubVolume, ///< Equal nodes of one sub-volume.
  Level,     ///< Equal nodes of all sub-volumes of the level, or its equal grids.
};

/// One level, with every choice made.
struct LevelPlan {
  int number = 1; ///< From 1, the highest.
  const LevelKind *kind = nullptr;
  Int3 log2Size;           ///< log2 of the cells along each axis.
  int log2CellSide = 0;    ///< log2 of the voxels along a cell's side.
  std::uint32_t reach = 0; ///< Largest stored distance; 0 if the kind stores none.
  Descent descent = Descent::Index;
  Sharing sharing = Sharing::None;
  bool stops = false;   ///< `Detail::Cone`: the walk may stop at nodes and cells of this level.
  bool sampled = false; ///< Where it stops, here or above, a colour is searched in sub-volumes of this level.
};

struct Plan {
  Format format;
  Addressing addressing = Addressing::Buffer;
  Predicate predicate = Predicate::Exact;
  Detail detail = Detail::Full;
  std::vector<LevelPlan> levels;
};

struct PlanOptions {
  Addressing addressing = Addressing::Buffer;
};

/// Makes every choice for a verified format.
Plan makePlan(const Format &format, const PlanOptions &options = {});

/// The plan as text, one line a level; for people and tests.
std::string printPlan(const Plan &plan);

std::string_view toString(Descent descent);
std::string_view toString(Predicate predicate);
std::string_view toString(Detail detail);
std::string_view toString(Sharing sharing);

} // namespace voxc
