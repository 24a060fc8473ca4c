// From levels to strata.
#include "Kinds.h"

#include <algorithm>

namespace voxc {

Stratum gridStratum(const Level &level, std::string_view slots) {
  Stratum stratum;
  stratum.log2Shape = level.log2Size();
  stratum.slots = findSlotKind(slots);
  stratum.sharing = level.get(kShareAttribute);
  return stratum;
}

Stratum treeStratum(const Level &level, std::string_view slots, LeafPlace place) {
  const int side = static_cast<int>(level.parameter(ParameterRole::Side));
  const int branching = std::max(static_cast<int>(level.parameter(ParameterRole::Branching)), 1);
  Stratum stratum;
  stratum.log2Shape = {branching, branching, branching};
  stratum.depth = side / branching;
  stratum.slots = findSlotKind(slots);
  stratum.encoding = Leaves{place};
  return stratum;
}

namespace {

/// What a level asks of the level above it, which leads to its sub-volumes.
class PointerLowering {
public:
  PointerLowering(const Format &format, Layout &layout, Diagnostics &diagnostics)
      : format_(format), layout_(layout), diagnostics_(diagnostics) {}

  void lower(std::size_t index) {
    const Level &level = format_.levels[index];
    const int bits = level.get(kPointersAttribute);
    const std::string_view numbered = index > 0 ? layout_.strata[index - 1].slots->numbered : "";
    if (bits > 0 && numbered.empty())
      return refuse(index, std::string(kMisplacedNumbers));
    if (bits == 0)
      return refuseWithoutNumbers(index);
    Stratum &above = layout_.strata[index - 1];
    above.slots = findSlotKind(numbered);
    above.encoding = Numbers{.bits = bits, .counts = level.get(kCountsAttribute)};
    if (level.get(kMasksAttribute) == MaskForm::Whole)
      return;
    layout_.strata[index].slots = findSlotKind("octants");
    layout_.strata[index].encoding = InArray{};
  }

private:
  void refuse(std::size_t index, const std::string &problem) {
    diagnostics_.error(format_.levels[index].range, "level " + std::to_string(index + 1) + problem);
  }

  void refuseWithoutNumbers(std::size_t index) {
    const Level &level = format_.levels[index];
    if (level.get(kCountsAttribute) == Counts::Octant)
      refuse(index, " has counts of octants, which stand behind short pointers in a masked(2, 2, 2), with "
                    "values=apart");
    if (level.get(kMasksAttribute) == MaskForm::Octants)
      refuse(index, " has masks by octants, which stand where short pointers lead to");
  }

  const Format &format_;
  Layout &layout_;
  Diagnostics &diagnostics_;
};

} // namespace

Layout lowerLevels(const Format &format, Diagnostics &diagnostics) {
  Layout layout;
  layout.setPayload(format.attributes.value(kPayloadAttribute));
  layout.alpha = format.attributes.get(kAlphaAttribute);
  layout.values = format.attributes.get(kValuesAttribute);
  layout.log2Granule = format.log2Granule();
  for (std::size_t i = 0; i < format.levels.size(); ++i) {
    const Level &level = format.levels[i];
    Stratum stratum = level.kind->lower(level);
    stratum.level = level.kind->name;
    stratum.log2Cell = format.log2CellSide(i);
    layout.strata.push_back(std::move(stratum));
  }
  PointerLowering pointers(format, layout, diagnostics);
  for (std::size_t i = 0; i < format.levels.size(); ++i)
    pointers.lower(i);
  layout.complete();
  for (Stratum &stratum : layout.strata)
    fitReach(stratum);
  return layout;
}

Layout layoutOf(const Format &format) {
  Diagnostics none;
  Layout layout = lowerLevels(format, none);
  layout.format = toString(format);
  layout.storageDigest = storageDigest(format);
  return layout;
}

} // namespace voxc
