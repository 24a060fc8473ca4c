// From levels to strata.
#include "Kinds.h"

#include <algorithm>
#include <charconv>

namespace voxc {

Stratum gridStratum(const Level &level, std::string_view slots) {
  Stratum stratum;
  stratum.log2Shape = level.log2Size();
  stratum.slots = findSlotKind(slots);
  if (level.attribute(kShareAttribute) == "level")
    stratum.sharing = Sharing::Stratum;
  return stratum;
}

Stratum treeStratum(const Level &level, std::string_view slots, Cells cells) {
  const int side = static_cast<int>(level.parameter(ParameterRole::Side));
  const int branching = std::max(static_cast<int>(level.parameter(ParameterRole::Branching)), 1);
  Stratum stratum;
  stratum.log2Shape = {branching, branching, branching};
  stratum.depth = side / branching;
  stratum.slots = findSlotKind(slots);
  stratum.leaves = true;
  stratum.cells = cells;
  return stratum;
}

namespace {

/// What a level with short pointers asks of its own stratum, the last so far, and of that above.
void numberSubVolumes(Layout &layout, const Level &level) {
  const std::string_view bits = level.attribute(kPointersAttribute);
  if (bits == "word")
    return;
  Stratum &stratum = layout.strata.back();
  Stratum &above = layout.strata[layout.strata.size() - 2];
  std::from_chars(bits.data(), bits.data() + bits.size(), above.indexBits);
  above.arrayHead = static_cast<int>(layout.headWords()) - 1;
  above.counts = *fromString<Counts>(level.attribute(kCountsAttribute));
  if (level.attribute(kMasksAttribute) == "octants") {
    above.grids = Grids::Octants;
    stratum.slots = findSlotKind("octants");
    stratum.arrayHead = above.arrayHead;
  }
}

} // namespace

Layout layoutOf(const Format &format) {
  Layout layout;
  layout.format = toString(format);
  layout.storageDigest = storageDigest(format);
  layout.setPayload(format.attributes.value(kPayloadAttribute));
  layout.alpha = *fromString<Alpha>(format.attributes.value(kAlphaAttribute));
  layout.values = *fromString<Values>(format.attributes.value(kValuesAttribute));
  layout.log2Granule = format.log2Granule();
  const bool voxelsAreEqual = !kindOf(layout.payload).varies || layout.values == Values::Apart;
  for (std::size_t i = 0; i < format.levels.size(); ++i) {
    const Level &level = format.levels[i];
    Stratum stratum = level.kind->lower(level);
    stratum.level = level.kind->name;
    stratum.log2Cell = format.log2CellSide(i);
    if (level.attribute(kDistancesAttribute) == "in-slot")
      packDistances(stratum, i + 1 == format.levels.size());
    const bool isLast = i + 1 == format.levels.size();
    stratum.implied = isLast && voxelsAreEqual && stratum.slots->tellsByMasks && stratum.depth > 0;
    stratum.ranked = layout.values == Values::Apart;
    layout.strata.push_back(std::move(stratum));
    if (i > 0)
      numberSubVolumes(layout, level);
  }
  return layout;
}

} // namespace voxc
