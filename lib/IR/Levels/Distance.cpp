// D: a grid whose cells carry the L1 distance to the nearest cell that is not empty, so that a ray may step
// over several. Two words a cell: the terminating integer, the distance.
#include "Kinds.h"

#include <limits>

namespace voxc {
namespace {

constexpr std::array<ParameterKind, 4> kParameters = {
    {kWidth,
     kHeight,
     kDepth,
     {"M", ParameterRole::Reach, "the largest distance stored, in cells", 1,
      std::numeric_limits<std::uint32_t>::max()}}};

constexpr std::array<const AttributeKind *, 2> kAttributes = {&kShareAttribute, &kDistancesAttribute};

Stratum lower(const Level &level) {
  Stratum stratum = gridStratum(level, kDenseSlots);
  stratum.skip = Skip::L1;
  stratum.reach = level.parameter(ParameterRole::Reach);
  return stratum;
}

} // namespace

const LevelKind kDistance = {
    'D',         "distance",
    "DF",        "a grid with the distance to the nearest full cell: long steps, twice the size",
    kParameters, kAttributes,
    lower};

} // namespace voxc
