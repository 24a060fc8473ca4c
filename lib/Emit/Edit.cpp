// Printing a plan as edit.cpp: a struct of constants a level, the last level first.
#include "ConstructLevel.h"

#include "voxc/Emit/Emit.h"

namespace voxc {
namespace {

std::vector<LevelAlias> aliases(const Stratum &stratum) {
  const SlotKind &kind = *stratum.slots;
  std::vector<LevelAlias> aliases = {{"Field", kind.measuring(stratum)},
                                     {"Mending", kind.mending(stratum)},
                                     {kind.root ? "Slots" : "Writing", kind.writing(stratum)},
                                     {"Editing", kind.edit}};
  if (kind.root)
    aliases.push_back({"Root", {kTree.header, kind.root(stratum)}});
  return aliases;
}

constexpr LevelForm kForm = {
    .voxels = "EditedVoxels",
    .subVolume = [](const Stratum &) -> std::string_view { return "Edited"; },
    .aliases = aliases,
    .header = [](const Stratum &) -> std::string_view { return "voxc_edited.h"; },
};

} // namespace

std::string emitEdit(const Plan &given) {
  Plan plan = given;
  for (Construction &construction : plan.constructions)
    construction.looksAhead = false; // There are too few nodes for it.
  return "// edit.cpp: edits volumes of the format " + plan.layout.format +
         ": what an edit touches is written anew, from the cells up to the root, and all\n// else stays "
         "where it is.\n" +
         constructLevels(plan, kForm) + "\nusing Volume = " + subVolumeOf(plan, kForm, 0) +
         ";\n\n} // namespace\n\n#include \"voxc_edit_entry.h\"\n";
}

} // namespace voxc
