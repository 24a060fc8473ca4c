// S: a sparse voxel octree. A node is [first child, masks], its non-empty children stand together; a leaf is
// [terminating integer, 0].
#include "Kinds.h"

namespace voxc {
namespace {

constexpr std::array<ParameterKind, 1> kParameters = {{
    {"L", ParameterRole::Side, "depth: log2 of the cells along each axis", 0, kMaxLog2Extent},
}};

constexpr std::array<const AttributeKind *, 1> kAttributes = {&kTraversalAttribute};

Stratum lower(const Level &level) { return treeStratum(level, "siblings"); }

} // namespace

extern const LevelKind kSvo = {
    'S',         "svo",       "SVO", "a sparse voxel octree: empty space costs nothing, two words a node",
    kParameters, kAttributes, lower};

} // namespace voxc
