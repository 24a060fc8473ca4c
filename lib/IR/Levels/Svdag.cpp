// G: a sparse voxel DAG. A node is [masks, child pointers...], equal nodes share storage; a leaf is
// [terminating integer].
#include "Kinds.h"

namespace voxc {
namespace {

constexpr std::array<ParameterKind, 2> kParameters = {{
    {"L", ParameterRole::Side, "log2 of the cells along each axis; the depth, with nodes of 2 x 2 x 2", 0,
     kMaxLog2Extent},
    {"B", ParameterRole::Branching, "log2 of a node's children along each axis; 1 if it is not written", 1, 2,
     1},
}};

constexpr std::array<const AttributeKind *, 4> kAttributes = {&kDedupAttribute, &kMirrorAttribute,
                                                              &kLeavesAttribute, &kTraversalAttribute};

Stratum lower(const Level &level) {
  // A tree of one cell has no slots.
  const bool hasSlots = level.parameter(ParameterRole::Side) > 0;
  Stratum stratum = treeStratum(level, hasSlots && level.get(kMirrorAttribute) ? "mirrored" : "packed");
  stratum.encoding = Leaves{hasSlots ? level.get(kLeavesAttribute) : LeafPlace::Apart};
  stratum.sharing = level.get(kDedupAttribute);
  return stratum;
}

} // namespace

extern const LevelKind kSvdag = {
    'G',         "svdag",     "SVDAG", "a sparse voxel DAG: an octree whose equal nodes share storage",
    kParameters, kAttributes, lower};

} // namespace voxc
