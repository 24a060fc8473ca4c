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

Stratum treeStratum(const Level &level, std::string_view slots) {
  const int side = static_cast<int>(level.parameter(ParameterRole::Side));
  const int branching = std::max(static_cast<int>(level.parameter(ParameterRole::Branching)), 1);
  Stratum stratum;
  stratum.log2Shape = {branching, branching, branching};
  stratum.depth = side / branching;
  stratum.slots = findSlotKind(slots);
  stratum.encoding = defaultEncoding(*stratum.slots);
  return stratum;
}

namespace {

/// What a level asks of the level above it, which leads to its sub-volumes, and what its choices ask of each
/// other.
class NeighbourLowering {
public:
  NeighbourLowering(const Format &format, Layout &layout, Diagnostics &diagnostics)
      : format_(format), layout_(layout), diagnostics_(diagnostics) {}

  void lower(std::size_t index) {
    const Level &level = format_.levels[index];
    for (const AttributeKind *kind : level.kind->attributes)
      if (kind->needs && isChosen(level, *kind) && !isChosen(level, *kind->needs))
        refuse(index, needText(level, *kind));
    Stratum *const above = index > 0 ? &layout_.strata[index - 1] : nullptr;
    if (level.kind->lead)
      refuse(index, level.kind->lead(level, layout_.strata[index], above));
  }

private:
  static bool isChosen(const Level &level, const AttributeKind &kind) {
    return level.attribute(kind) != kind.values.front();
  }

  static std::string needText(const Level &level, const AttributeKind &kind) {
    return " has " + std::string(kind.name) + "=" + std::string(level.attribute(kind)) + ", which needs " +
           std::string(kind.needs->name) + " (" + std::string(kind.needs->byPasses) + ")";
  }

  void refuse(std::size_t index, const std::string &problem) {
    if (!problem.empty())
      diagnostics_.error(format_.levels[index].range, "level " + std::to_string(index + 1) + problem);
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
  layout.log2Granule = format.attributes.get(kGranuleAttribute);
  for (std::size_t i = 0; i < format.levels.size(); ++i) {
    const Level &level = format.levels[i];
    Stratum stratum = level.kind->lower(level);
    stratum.level = level.kind->name;
    stratum.log2Cell = format.log2CellSide(i);
    layout.strata.push_back(std::move(stratum));
  }
  NeighbourLowering neighbours(format, layout, diagnostics);
  for (std::size_t i = 0; i < format.levels.size(); ++i)
    neighbours.lower(i);
  layout.complete();
  for (Stratum &stratum : layout.strata)
    fitReach(stratum);
  return layout;
}

bool hasLabels(const Format &format) {
  Layout layout;
  layout.setPayload(format.attributes.value(kPayloadAttribute));
  return layout.hasLabels();
}

Layout layoutOf(const Format &format) {
  Diagnostics none;
  Layout layout = lowerLevels(format, none);
  layout.format = toString(format);
  layout.storageDigest = storageDigest(format);
  return layout;
}

} // namespace voxc
