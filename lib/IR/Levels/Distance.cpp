// D: a grid whose empty cells tell how far a ray may step: the L1 distance to the nearest cell that is not
// empty, or empty cubes by octant. Two words a cell, the terminating integer and the distance, or one.
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

constexpr std::array<const AttributeKind *, 3> kAttributes = {&kShareAttribute, &kDistancesAttribute,
                                                              &kMetricAttribute};

Stratum lower(const Level &level) {
  Stratum stratum = gridStratum(level, "dense");
  stratum.encoding = Distances{.metric = level.get(kMetricAttribute),
                               .reach = level.parameter(ParameterRole::Reach),
                               .place = level.get(kDistancesAttribute)};
  return stratum;
}

} // namespace

extern const LevelKind kDistance = {
    'D',         "distance",
    "DF",        "a grid with the distance to the nearest full cell: long steps, twice the size",
    kParameters, kAttributes,
    lower};

} // namespace voxc
