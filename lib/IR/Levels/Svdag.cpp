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

constexpr std::array<const AttributeKind *, 3> kAttributes = {&kDedupAttribute, &kLeavesAttribute,
                                                              &kWalkAttribute};

Stratum lower(const Level &level) {
  Stratum stratum = treeStratum(level, "packed", Cells::Word);
  if (stratum.depth > 0 && level.attribute(kLeavesAttribute) == "in-slot")
    stratum.cells = Cells::Slot;
  stratum.sharing = level.attribute(kDedupAttribute) == "level" ? Sharing::Stratum : Sharing::SubVolume;
  return stratum;
}

} // namespace

extern const LevelKind kSvdag = {
    'G',         "svdag",     "SVDAG", "a sparse voxel DAG: an octree whose equal nodes share storage",
    kParameters, kAttributes, lower};

} // namespace voxc
