// The names that templates speak of.
#include "Names.h"

#include "MemoryNames.h"
#include "QuestionNames.h"
#include "StepNames.h"

#include "Layout/Masks.h"

#include "voxc/Layout/SlotKind.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace voxc {
namespace {

/// What the files of its kind of slots alone speak of.
void addOwnNames(TemplateNames &names, const Stratum &stratum) {
  for (const RuntimeName &own : stratum.slots->names(stratum))
    if (const bool *const condition = std::get_if<bool>(&own.value))
      names.conditions[std::string(own.name)] = *condition;
    else
      names.holes[std::string(own.name)] = std::get<std::string>(own.value);
}

/// How a distance field's word tells of an empty cell, in generated text.
void addSkip(TemplateNames &names, const Stratum &stratum) {
  const bool isTagged = stratum.empty() == Empty::Tagged;
  const bool hasOctants = stratum.slots->region(stratum) == EmptyRegion::Cube;
  const std::string shift = stratum.tagShift() == 0 ? "" : std::to_string(stratum.tagShift());
  const std::string fieldBits = std::to_string(stratum.fieldBits());
  const std::string fieldMask = std::to_string((1 << stratum.fieldBits()) - 1);
  const bool isBeside = stratum.distances() && stratum.distances()->place == DistancePlace::Beside;
  auto &[holes, conditions] = names;
  conditions["distances"] = stratum.distances() != nullptr;
  conditions["distances-beside"] = isBeside;
  conditions["distances-in-slot"] = stratum.distances() && !isBeside;
  holes["words-of-slot"] = std::string("terminating integer") + (isBeside ? ", distance" : "") +
                           (stratum.ranked ? ", voxels before" : "");
  holes["field-bits"] = fieldBits;
  holes["field-mask"] = fieldMask;
  holes["ones"] = stratum.fieldBits() == 4 ? "0x11111111u" : "011111111u";
  holes["slot-of-value"] = shift.empty() ? "placed.value" : "placed.value << " + shift;
  holes["value-at-slot"] = stratum.empty() == Empty::Zero
                               ? "load_word(" + holes["grid,"] + "slot)"
                               : "value_level_" + holes["N"] + "(load_word(" + holes["grid,"] + "slot))";
  holes["value-of-slot"] = shift.empty() ? "word" : "word >> " + shift;
  holes["what-skip-counts"] =
      hasOctants ? "the cells along the largest empty cube ahead" : "its distance, in cells";
  holes["skip-of-slot"] = hasOctants ? fieldBits + " bits for each octant" : "its distance";
  holes["skip-in-word"] =
      hasOctants ? "skip >> (ray.octant * " + fieldBits + ") & " + fieldMask + "u" : "skip & 0x7fffffffu";
  holes["empty-slots"] = !isTagged    ? "with an alpha of 0"
                         : hasOctants ? "whose lowest field is not 0"
                                      : "with its highest bit set";
  holes["empty-tag"] = isTagged ? "0x80000000u" : "0u";
  const std::string emptyBits = !isTagged ? " >> 24" : hasOctants ? " & " + fieldMask : " >> 31";
  holes["word-is-empty"] = "(word" + emptyBits + (isTagged ? ") != 0" : ") == 0");
  holes["slot-is-empty"] =
      "(word" + emptyBits + (isTagged && hasOctants ? "u" : "") + (isTagged ? ") != 0u" : ") == 0u");
}

std::string count(int log2, std::string_view unit) {
  const std::int64_t number = std::int64_t{1} << log2;
  return std::to_string(number) + " " + std::string(unit) + (number == 1 ? "" : "s");
}

void addHoles(TemplateNames &names, const Plan &plan, std::size_t index) {
  const Stratum &stratum = plan.layout.strata[index];
  const int branch = stratum.log2Shape.x;
  const std::string factor = std::to_string(branch);
  auto &holes = names.holes;
  holes["N"] = std::to_string(index + 1);
  holes["path"] = plan.sharesStack() ? "path_level_" + holes["N"] : "path";
  holes["NEXT"] = plan.layout.holdsVoxels(index) ? "voxel" : "level_" + std::to_string(index + 2);
  holes["DEPTH"] = std::to_string(stratum.depth);
  holes["outside"] = index == 0 ? "empty" : "not known, and taken to be full";
  holes["outside-side"] = index == 0 ? "LEVEL_" + holes["N"] + "_REACH" : "0";
  holes["write"] = stratum.sharing == Sharing::Level ? "intern" : "append";
  holes["slot-words"] = std::to_string(stratum.slotWords());
  holes["mask-stride"] = countsMaskWords(stratum) ? "2u * " : "";
  holes["count-bits"] = std::to_string(stratum.countBits());
  holes["second-mask"] = stratum.log2Children() == 6 ? " + uint(bitCount(load_word(grid + 1u)))" : "";
  holes["slots-times"] = stratum.slotWords() == 1 ? "" : std::to_string(stratum.slotWords()) + "u * ";
  holes["slot-words-times"] = stratum.slotWords() == 1 ? "" : std::to_string(stratum.slotWords()) + " * ";
  holes["times-branch"] = branch == 1 ? "" : " * " + factor;
  holes["per-branch"] = branch == 1 ? "" : " / " + factor;
  const std::string height = "highest - LEVEL_" + holes["N"] + "_LOG2_CELL";
  holes["highest-layer"] = branch == 1 ? height : "(" + height + ") / " + factor;
  const std::uint64_t slotWords = static_cast<std::uint64_t>(stratum.slotWords());
  holes["head-words"] =
      std::to_string(stratum.slots->leastWords(stratum) - (stratum.implied ? 0 : slotWords));
  holes["around"] = MaskShape(stratum).hasTwoSets() ? ", around" : "";
  holes["plus-around"] = MaskShape(stratum).hasTwoSets() ? " + around" : "";
}

/// What a look-up of a cell takes beside the cell: the ray, and the gap that it may widen.
void addCellArguments(TemplateNames &names, const Plan &plan, std::size_t index) {
  const Stratum &stratum = plan.layout.strata[index];
  const bool isPoint = plan.isOfPoints();
  const bool tells = !isPoint && reportsEmptyRegion(stratum);
  const bool takesRay = tells && !reportsBall(stratum);
  const bool takesGap = tells || plan.traversals[index].lookUp == Loops::Cut;
  names.holes["cell-ray-and"] = takesRay ? "const Ray ray, " : "";
  names.holes["cell-and-gap"] = takesGap ? ", inout Gap gap" : "";
  names.holes["cell-ray,"] = takesRay ? "ray, " : "";
  names.holes["cell,gap"] = takesGap ? ", gap" : "";
}

/// How a leaf of a stratum, or a full cell, becomes its value in generated text.
void addLeaves(TemplateNames &names, const Plan &plan, std::size_t index) {
  const Stratum &stratum = plan.layout.strata[index];
  auto &holes = names.holes;
  const bool defers = plan.defersValues && plan.layout.holdsVoxels(index);
  const std::string occupied = holes["occupied"];
  const auto leafAt = [&](const std::string &at) {
    const bool isValue = defers || stratum.leavesInSlots();
    return stratum.implied && !defers ? occupied : isValue ? at : "load_word(" + at + ")";
  };
  holes["full-cell"] = defers            ? "grid"
                       : stratum.implied ? occupied
                                         : "value_level_" + holes["N"] + "(grid, cell)";
  holes["first-slot"] = stratum.implied ? "leaf ? node : load_word(" : "load_word(";
  holes["without-leaves"] = stratum.implied ? " & ~load_word(node" + holes["+"] + "2u)" : "";
  holes["slots-of-children"] = stratum.implied ? "children.filled & ~children.leaves" : "children.filled";
  holes["have-slots"] = stratum.implied ? "are neither empty nor leaves" : "are not empty";
  holes["slots-hold"] = stratum.leavesInSlots() ? "values of leaves and references to" : "references to";
  holes["why-alike"] =
      stratum.implied ? "All leaves have the same value." : "Of a leaf, nothing more is asked.";
  holes["leaf-node"] = leafAt("node");
  holes["leaf-leaf"] = leafAt("leaf");
  holes["leaf-found"] = leafAt("found");
  holes["leaf-or-0"] = leafAt("node") == "node" ? "node" : "node == 0u ? 0u : " + leafAt("node");
}

/// Where the layers of a stratum lie among those of all strata.
void addLayers(TemplateNames &names, const Plan &plan, std::size_t index) {
  int begin = 0;
  for (std::size_t i = 0; i < index; ++i)
    begin += flatLayers(plan.layout.strata[i]);
  const int end = begin + flatLayers(plan.layout.strata[index]);
  const bool isLast = plan.layout.holdsVoxels(index);
  auto &holes = names.holes;
  holes["BEGIN"] = std::to_string(begin);
  holes["END"] = std::to_string(end);
  holes["LOWEST"] = isLast ? std::to_string(end - 1) : "lowest_" + holes["N"];
  const int branch = plan.layout.strata[index].log2Shape.x;
  const std::string above = "LEVEL_" + holes["N"] + "_LOG2_SIDE - 1 - highest";
  holes["climb"] = branch == 1 ? above : "(" + above + ") / " + std::to_string(branch);
  holes["LAST"] = std::to_string(end - 1);
  const std::string where =
      std::string(index == 0 ? "" : "} else ") + (isLast ? "" : "if (layer < " + std::to_string(end) + ") ");
  holes["WHERE"] = plan.layout.strata.size() == 1 ? "" : where;
}

void addConditions(TemplateNames &names, const Plan &plan, std::size_t index) {
  const Stratum &stratum = plan.layout.strata[index];
  auto &conditions = names.conditions;
  conditions["first"] = index == 0;
  conditions["wide"] = MaskShape(stratum).hasTwoSets();
  conditions["last"] = plan.layout.holdsVoxels(index);
  conditions["single"] = !stratum.isGrid() && stratum.depth == 0;
  conditions["tree"] = !stratum.isGrid() && stratum.depth > 0;
  conditions["look-up-may-be-cut"] = plan.traversals[index].lookUp == Loops::Cut;
  conditions["implied"] = stratum.implied;
  conditions["leaves-in-slots"] = stratum.leavesInSlots();
  conditions["grid"] = stratum.isGrid();
  conditions["leaves-apart"] = stratum.hasLeafWords();
  conditions["ranked"] = stratum.ranked;
  conditions["looks-ahead"] = plan.constructions[index].looksAhead;
  conditions["ranks"] = stratum.ranked && storesValue(plan.outputs);
  conditions["slots-count"] = stratum.ranked && !stratum.implied;
  conditions["slots-rank"] = stratum.ranked && !stratum.implied && storesValue(plan.outputs);
  conditions["counts"] = countsMaskWords(stratum);
  conditions["alike"] = stratum.implied || !plan.traversals[index].readsValues;
  conditions["defers"] = plan.defersValues && plan.layout.holdsVoxels(index);
  conditions["one-voxel-steps"] = plan.traversals[index].voxelSteps;
  conditions["marches"] = reportsBall(stratum);
  conditions["chooses-faces"] = findsValueLater(stratum);
  conditions["tells-half"] = stratum.slots->region(stratum) == EmptyRegion::Octant;
  conditions["walks"] = !plan.isOfPoints();
  conditions["stops"] = plan.traversals[index].stops;
  conditions["sampled"] = plan.traversals[index].sampled;
  conditions["shares-sub-volumes-apart"] = stratum.sharing == Sharing::SubVolume;
}

/// The low half of a digest and the high one, since GLSL has no number of 64 bits.
std::string halvesOf(std::uint64_t digest) {
  char text[32];
  std::snprintf(text, sizeof text, "0x%08xu, 0x%08xu", static_cast<unsigned>(digest),
                static_cast<unsigned>(digest >> 32));
  return text;
}

std::string hexadecimal(std::uint64_t number) {
  char digits[19];
  std::snprintf(digits, sizeof digits, "0x%016llx", static_cast<unsigned long long>(number));
  return digits;
}

} // namespace

int flatLayers(const Stratum &stratum) { return std::max(stratum.depth, 1); }

std::string intVector(Int3 v) {
  return "ivec3(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + ")";
}

TemplateNames planNames(const Plan &plan) {
  const Int3 log2 = plan.layout.log2Extent();
  const bool cut = plan.loops == Loops::Cut;
  TemplateNames names;
  names.holes["FORMAT"] = plan.layout.format;
  names.holes["DIGEST"] = hexadecimal(plan.layout.storageDigest);
  names.holes["digest-words"] = halvesOf(plan.layout.storageDigest);
  names.holes["digest-halves"] = "uvec2(" + names.holes["digest-words"] + ")";
  names.holes["VOLUME_SIZE"] = intVector({1 << log2.x, 1 << log2.y, 1 << log2.z});
  names.holes["order-known"] = cut ? "order != CUT_SHORT && " : "";
  const Stratum &lowest = plan.layout.strata.back();
  names.holes["LOWEST_LEVEL"] = std::to_string(plan.layout.strata.size());
  addQuestionNames(names, plan);
  addMemoryNames(names, plan);
  addStepNames(names, plan);
  names.conditions["value-later"] = plan.defersValues && findsValueLater(lowest);
  names.holes["occupied"] = "0xffffffffu";
  names.conditions["defers-leaf"] = plan.defersValues && !lowest.isGrid() && !lowest.leavesInSlots();
  names.conditions["values-apart"] = plan.layout.ranksVoxels();
  names.conditions["cut"] = cut;
  names.conditions["resumes"] = cut || plan.addressing == Addressing::Paged;
  names.conditions["cone"] = plan.stopsAboveVoxels();
  int layers = 0;
  for (const Stratum &stratum : plan.layout.strata)
    layers += flatLayers(stratum);
  names.holes["LAYERS"] = std::to_string(layers);
  names.conditions["any-look-up-may-be-cut"] = std::ranges::any_of(
      plan.traversals, [](const Traversal &traversal) { return traversal.lookUp == Loops::Cut; });
  names.conditions["any-wide"] = std::ranges::any_of(
      plan.layout.strata, [](const Stratum &stratum) { return MaskShape(stratum).hasTwoSets(); });
  return names;
}

TemplateNames stratumNames(const Plan &plan, std::size_t index) {
  TemplateNames names = planNames(plan);
  addHoles(names, plan, index);
  addReferenceNames(names, plan.layout, plan.layout.strata[index]);
  addLeaves(names, plan, index);
  addSkip(names, plan.layout.strata[index]);
  addOwnNames(names, plan.layout.strata[index]);
  addCellArguments(names, plan, index);
  addLayers(names, plan, index);
  addConditions(names, plan, index);
  return names;
}

TemplateNames layerNames(const Plan &plan, std::size_t index, int layer) {
  TemplateNames names = stratumNames(plan, index);
  names.holes["H"] = std::to_string(layer);
  names.holes["H-1"] = std::to_string(layer - 1);
  names.conditions["inner"] = layer > 1;
  return names;
}

std::string levelComment(const Plan &plan, std::size_t index) {
  const Stratum &stratum = plan.layout.strata[index];
  const Int3 size = stratum.log2Size();
  return "\n// Level " + std::to_string(index + 1) + ": " + stratum.level + ", " +
         std::to_string(1 << size.x) + " x " + std::to_string(1 << size.y) + " x " + count(size.z, "cell") +
         " of " + count(stratum.log2Cell, "voxel") + " a side.\n";
}

} // namespace voxc
