// M: a masked grid. A bit for each cell that is not empty, and their values next to each other; the node of
// VDB.
#include "Kinds.h"

namespace voxc {
namespace {

constexpr std::array<ParameterKind, 3> kParameters = {kWidth, kHeight, kDepth};
constexpr std::array<const AttributeKind *, 4> kAttributes = {&kShareAttribute, &kPointersAttribute,
                                                              &kCountsAttribute, &kMasksAttribute};

Stratum lower(const Level &level) {
  return gridStratum(level, level.log2Size() == kLog2BrickShape ? "brick" : "masked");
}

/// Numbers that lead to the sub-volumes.
std::string lead(const Level &level, Stratum &own, Stratum *above) {
  const int bits = level.get(kPointersAttribute);
  if (bits == 0)
    return {};
  if (!above || above->slots->numbered.empty())
    return std::string(kMisplacedNumbers);
  above->slots = findSlotKind(above->slots->numbered);
  above->encoding = Numbers{.bits = bits, .counts = level.get(kCountsAttribute)};
  if (level.get(kMasksAttribute))
    own.slots = findSlotKind("octants");
  return {};
}

} // namespace

extern const LevelKind kMasked = {
    'M',         "masked",
    "Masked",    "a grid with a bit a cell: empty cells cost one bit, a lookup two loads more",
    kParameters, kAttributes,
    lower,       lead};

} // namespace voxc
