// What plans and strata decide, a row each.
#include "Emit/KernelConstants.h"

#include "Emit/Names.h"

#include "Layout/Masks.h"

#include "voxc/Layout/SlotKind.h"

#include <algorithm>

namespace voxc {
namespace {

using Value = ConstantValue;

const Stratum &at(const Plan &plan, std::size_t index) { return plan.layout.strata[index]; }
std::uint32_t words(int count) { return static_cast<std::uint32_t>(count); }

constexpr PlanConstant kPlan[] = {
    // How words are reached.
    {"GRANULES", [](const Plan &p) -> Value { return p.layout.log2Granule > 0; }},
    {"LOG2_GRANULE", [](const Plan &p) -> Value { return p.layout.log2Granule; }},
    {"PAGED", [](const Plan &p) -> Value { return p.addressing == Addressing::Paged; }},
    // What is asked.
    {"POINT", [](const Plan &p) -> Value { return p.isOfPoints(); }},
    {"ARRIVAL", [](const Plan &p) -> Value { return p.outputs.t || p.outputs.face; }},
    {"VOXEL", [](const Plan &p) -> Value { return p.outputs.voxel; }},
    {"T", [](const Plan &p) -> Value { return p.outputs.t; }},
    {"FACE", [](const Plan &p) -> Value { return p.outputs.face; }},
    {"COLOUR", [](const Plan &p) -> Value { return storesValue(p.outputs); }},
    {"BOUNDED", [](const Plan &p) -> Value { return p.bounded; }},
    {"CONE", [](const Plan &p) -> Value { return p.stopsAboveVoxels(); }},
    // The arithmetic of steps, and what a turn of a loop waits for.
    {"DOUBLES", [](const Plan &p) -> Value { return p.steps == StepArithmetic::Float64; }},
    {"BY_BITS", [](const Plan &p) -> Value { return p.compare == Compare::Bits; }},
    {"REFINES", [](const Plan &p) -> Value { return p.steps == StepArithmetic::Refined; }},
    {"PACKETS", [](const Plan &p) -> Value { return p.packing == Packing::Packets; }},
    {"NARROW_PACKETS", [](const Plan &p) -> Value { return p.packetWidth == PacketWidth::Narrow; }},
    {"EXACT", [](const Plan &p) -> Value { return p.isExact(); }},
    {"IEEE", [](const Plan &p) -> Value { return p.arithmetic == Arithmetic::Ieee; }},
    {"NEAREST", [](const Plan &p) -> Value { return p.arithmetic == Arithmetic::Nearest; }},
    {"KEEPS_CELL", [](const Plan &p) -> Value { return p.speculative; }},
    {"REPORTS_FACES", [](const Plan &p) -> Value { return p.spanFaces == SpanFaces::Lookup; }},
    {"CUT", [](const Plan &p) -> Value { return p.loops == Loops::Cut; }},
    {"LOOK_UPS_MAY_BE_CUT",
     [](const Plan &p) -> Value {
       return std::ranges::find(p.traversals, Loops::Cut, &Traversal::lookUp) != p.traversals.end();
     }},
    // What a voxel is.
    {"OCCUPIED", [](const Plan &) -> Value { return 0xffffffffu; }},
    {"VALUES_APART", [](const Plan &p) -> Value { return p.layout.ranksVoxels(); }},
    {"DEFERS_VALUES", [](const Plan &p) -> Value { return p.defersValues; }},
    {"LOWEST_DEFERS_VALUES", [](const Plan &p) -> Value { return defersValue(p.layout.strata.back()); }},
    {"LOWEST_HAS_LEAF_WORDS",
     [](const Plan &p) -> Value {
       return !p.layout.strata.back().isGrid() && !p.layout.strata.back().leavesInSlots();
     }},
    // The path of a flat traversal.
    {"LEVELS", [](const Plan &p) -> Value { return static_cast<int>(p.layout.strata.size()); }},
    {"LAYERS", [](const Plan &p) -> Value { return firstLayer(p.layout, p.layout.strata.size()); }},
    {"KEEPS_LOWEST",
     [](const Plan &p) -> Value {
       return std::ranges::any_of(p.layout.strata.begin(), p.layout.strata.end() - 1, &Stratum::hasLayers);
     }},
};

constexpr LevelConstant kLevel[] = {
    // Where it stands.
    {"INDEX", [](const Plan &, std::size_t i) -> Value { return static_cast<int>(i); }},
    {"FIRST", [](const Plan &, std::size_t i) -> Value { return i == 0; }},
    {"LAST", [](const Plan &p, std::size_t i) -> Value { return p.layout.holdsVoxels(i); }},
    {"BEGIN", [](const Plan &p, std::size_t i) -> Value { return firstLayer(p.layout, i); }},
    {"END", [](const Plan &p, std::size_t i) -> Value { return firstLayer(p.layout, i + 1); }},
    // Its shape.
    {"GRID", [](const Plan &p, std::size_t i) -> Value { return at(p, i).isGrid(); }},
    {"HAS_LAYERS", [](const Plan &p, std::size_t i) -> Value { return at(p, i).hasLayers(); }},
    {"WIDE", [](const Plan &p, std::size_t i) -> Value { return MaskShape(at(p, i)).hasTwoSets(); }},
    {"BITS_OF_X", [](const Plan &p, std::size_t i) -> Value { return at(p, i).log2Size().x; }},
    {"BITS_OF_Y", [](const Plan &p, std::size_t i) -> Value { return at(p, i).log2Size().y; }},
    {"BITS_OF_Z", [](const Plan &p, std::size_t i) -> Value { return at(p, i).log2Size().z; }},
    // Its words.
    {"IMPLIED", [](const Plan &p, std::size_t i) -> Value { return at(p, i).implied; }},
    {"LEAVES_IN_SLOTS", [](const Plan &p, std::size_t i) -> Value { return at(p, i).leavesInSlots(); }},
    {"SLOT_WORDS", [](const Plan &p, std::size_t i) -> Value { return words(at(p, i).slotWords()); }},
    {"HEAD_WORDS", [](const Plan &p, std::size_t i) -> Value { return headWords(at(p, i)); }},
    {"RECORD_GRANULES",
     [](const Plan &p, std::size_t i) -> Value {
       const Stratum &stratum = at(p, i);
       return static_cast<std::uint32_t>(stratum.slots->leastWords(stratum) >> p.layout.log2Granule);
     }},
    {"COUNTS", [](const Plan &p, std::size_t i) -> Value { return countsMaskWords(at(p, i)); }},
    {"COUNT_BITS", [](const Plan &p, std::size_t i) -> Value { return words(at(p, i).countBits()); }},
    {"HAS_TWO_MASK_WORDS",
     [](const Plan &p, std::size_t i) -> Value { return at(p, i).log2Children() == 6; }},
    // Its distances.
    {"DISTANCES_BESIDE",
     [](const Plan &p, std::size_t i) -> Value {
       const Distances *const distances = at(p, i).distances();
       return distances && distances->place == DistancePlace::Beside;
     }},
    {"DISTANCES_IN_SLOT",
     [](const Plan &p, std::size_t i) -> Value {
       const Distances *const distances = at(p, i).distances();
       return distances && distances->place != DistancePlace::Beside;
     }},
    {"DISTANCES_OF_OCTANTS",
     [](const Plan &p, std::size_t i) -> Value {
       return at(p, i).slots->region(at(p, i)) == EmptyRegion::Cube;
     }},
    {"EMPTY_BY_ALPHA",
     [](const Plan &p, std::size_t i) -> Value { return at(p, i).empty() != Empty::Tagged; }},
    {"FIELD_BITS", [](const Plan &p, std::size_t i) -> Value { return at(p, i).fieldBits(); }},
    {"FIELD_MASK",
     [](const Plan &p, std::size_t i) -> Value { return (std::uint32_t{1} << at(p, i).fieldBits()) - 1; }},
    {"TAG_SHIFT", [](const Plan &p, std::size_t i) -> Value { return at(p, i).tagShift(); }},
    // How it is traversed.
    {"ALIKE",
     [](const Plan &p, std::size_t i) -> Value { return at(p, i).implied || !p.traversals[i].readsValues; }},
    {"DEFERS",
     [](const Plan &p, std::size_t i) -> Value { return p.defersValues && p.layout.holdsVoxels(i); }},
    {"ONE_VOXEL_STEPS", [](const Plan &p, std::size_t i) -> Value { return p.traversals[i].voxelSteps; }},
    {"MARCHES", [](const Plan &p, std::size_t i) -> Value { return reportsBall(at(p, i)); }},
    {"CHOOSES_FACES", [](const Plan &p, std::size_t i) -> Value { return defersValue(at(p, i)); }},
    {"TELLS_HALF",
     [](const Plan &p, std::size_t i) -> Value {
       return at(p, i).slots->region(at(p, i)) == EmptyRegion::Octant;
     }},
    {"LOOK_UP_MAY_BE_CUT",
     [](const Plan &p, std::size_t i) -> Value { return p.traversals[i].lookUp == Loops::Cut; }},
    {"STOPS", [](const Plan &p, std::size_t i) -> Value { return p.traversals[i].stops; }},
};

} // namespace

std::span<const PlanConstant> planConstants() { return kPlan; }
std::span<const LevelConstant> levelConstants() { return kLevel; }

std::string literal(const ConstantValue &value) {
  if (const bool *const truth = std::get_if<bool>(&value))
    return *truth ? "true" : "false";
  if (const int *const number = std::get_if<int>(&value))
    return std::to_string(*number);
  const std::uint32_t number = std::get<std::uint32_t>(value);
  return number == 0xffffffffu ? "0xffffffffu" : std::to_string(number) + "u";
}

std::string constantText(std::string_view name, const ConstantValue &value) {
  constexpr std::string_view kTypes[] = {"bool", "int", "uint32_t"}; // In the order of `ConstantValue`.
  std::string number = literal(value);
  if (number.ends_with('u')) // As the type says.
    number.pop_back();
  return std::string(kTypes[value.index()]) + " " + std::string(name) + " = " + number + ";";
}

glsl::Constants constantsOf(const Plan &plan) {
  glsl::Constants constants;
  for (const PlanConstant &constant : kPlan)
    constants[std::string(constant.name)] = literal(constant.of(plan));
  return constants;
}

glsl::Constants constantsOf(const Plan &plan, std::size_t index) {
  glsl::Constants constants;
  const auto add = [&](std::string_view name, const ConstantValue &value) {
    constants["LEVEL_" + std::string(name)] = literal(value);
  };
  for (const LevelConstant &constant : kLevel)
    add(constant.name, constant.of(plan, index));
  const Stratum &stratum = at(plan, index);
  for (const SlotConstant &own : stratum.slots->constants(stratum))
    add(own.name, std::visit([](auto value) { return ConstantValue(value); }, own.value));
  if (stratum.log2Shape.x == 1) // Else its name is worth more than the number.
    constants["LEVEL_BRANCH"] = "1";
  return constants;
}

} // namespace voxc
