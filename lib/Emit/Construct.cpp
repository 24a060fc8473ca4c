// Printing a plan as construct.cpp: a struct of constants a level, the last level first.
#include "ConstructLevel.h"

#include "voxc/Emit/Emit.h"

namespace voxc {
namespace {

std::vector<LevelAlias> aliases(const Stratum &stratum) {
  const SlotKind &kind = *stratum.slots;
  if (kind.root)
    return {{"Slots", kind.writing(stratum)}, {"Root", {kTree.header, kind.root(stratum)}}};
  return {{"Writing", kind.writing(stratum)}, {"Field", kind.measuring(stratum)}};
}

constexpr LevelForm kForm = {
    .voxels = "Voxels",
    .subVolume = [](const Stratum &stratum) { return stratum.slots->construct.name; },
    .aliases = aliases,
    .header = [](const Stratum &stratum) { return stratum.slots->construct.header; },
};

} // namespace

std::string emitConstruct(const Plan &plan) {
  std::string text = "// construct.cpp: builds volumes of the format " + plan.layout.format + ".\n" +
                     constructLevels(plan, kForm) + "\nusing Volume = Levels<";
  for (std::size_t i = 0; i < plan.layout.strata.size(); ++i)
    text += (i == 0 ? "" : ", ") + subVolumeOf(plan, kForm, i);
  return text + ">;\n\n} // namespace\n\n#include \"voxc_construct_entry.h\"\n";
}

} // namespace voxc
