// Constants of levels, a row each.
#include "ConstructConstants.h"

#include "KernelConstants.h"

#include "voxc/Layout/SlotKind.h"

#include <algorithm>
#include <iterator>

namespace voxc {
namespace {

using Value = ConstantValue;

const Stratum &at(const Plan &plan, std::size_t index) { return plan.layout.strata[index]; }

constexpr LevelConstant kConstruct[] = {
    // Where it stands, and its shape.
    {"NUMBER", [](const Plan &, std::size_t i) -> Value { return static_cast<std::uint32_t>(i + 1); }},
    {"LAYERS", [](const Plan &p, std::size_t i) -> Value { return at(p, i).depth; }},
    {"BRANCH", [](const Plan &p, std::size_t i) -> Value { return at(p, i).log2Shape.x; }},
    {"CHILDREN", [](const Plan &p, std::size_t i) -> Value { return 1 << at(p, i).log2Children(); }},
    {"LOG2_CELL", [](const Plan &p, std::size_t i) -> Value { return at(p, i).log2Cell; }},
    {"LOG2_SIDE",
     [](const Plan &p, std::size_t i) -> Value {
       return maxComponent(at(p, i).log2Size()) + at(p, i).log2Cell;
     }},
    // Its words.
    {"RANKED", [](const Plan &p, std::size_t i) -> Value { return at(p, i).ranked; }},
    {"HAS_LEAF_WORDS", [](const Plan &p, std::size_t i) -> Value { return at(p, i).hasLeafWords(); }},
    {"INTERNS", [](const Plan &p, std::size_t i) -> Value { return at(p, i).sharing == Sharing::Level; }},
    {"FORGETS", [](const Plan &p, std::size_t i) -> Value { return at(p, i).sharing == Sharing::SubVolume; }},
    {"EMPTY_IS_ZERO", [](const Plan &p, std::size_t i) -> Value { return at(p, i).empty() == Empty::Zero; }},
    {"DISTANCES", [](const Plan &p, std::size_t i) -> Value { return at(p, i).distances() != nullptr; }},
    {"REACH",
     [](const Plan &p, std::size_t i) -> Value {
       const Distances *const distances = at(p, i).distances();
       return distances ? static_cast<std::uint32_t>(distances->reach) : 0u;
     }},
    // How it is built.
    {"BRICKS", [](const Plan &p, std::size_t i) -> Value { return p.constructions[i].bricks; }},
    {"LOOKS_AHEAD", [](const Plan &p, std::size_t i) -> Value { return p.constructions[i].looksAhead; }},
};

ConstructConstant constantOf(std::string_view name, const Value &value) {
  return {std::string(name), constantText(name, value)};
}

/// What is asked of grids alone.
constexpr std::string_view kOfGrids[] = {"SHAPE", "INTERNS"};

/// What is asked of distances alone.
constexpr std::string_view kOfDistances[] = {"EMPTY_IS_ZERO",        "REACH",      "DISTANCES_BESIDE",
                                             "DISTANCES_OF_OCTANTS", "FIELD_BITS", "FIELD_MASK",
                                             "EMPTY_BY_ALPHA",       "TAG_SHIFT",  "FIRST"};

ConstructConstant shapeOf(const Plan &plan, std::size_t index) {
  const Int3 size = at(plan, index).log2Shape;
  return {"SHAPE", "GridShape SHAPE = {" + std::to_string(size.x) + ", " + std::to_string(size.y) + ", " +
                       std::to_string(size.z) + ", " + std::to_string(at(plan, index).log2Cell) + ", " +
                       (plan.layout.holdsVoxels(index) ? "true" : "false") + "};"};
}

} // namespace

std::vector<ConstructConstant> constructConstants(const Plan &plan, std::size_t index) {
  std::vector<ConstructConstant> constants;
  for (const LevelConstant &constant : kConstruct)
    constants.push_back(constantOf(constant.name, constant.of(plan, index)));
  constants.push_back(shapeOf(plan, index));
  for (const LevelConstant &constant : levelConstants())
    constants.push_back(constantOf(constant.name, constant.of(plan, index)));
  for (const SlotConstant &own : at(plan, index).slots->constants(at(plan, index)))
    constants.push_back(constantOf(own.name, std::visit([](auto value) { return Value(value); }, own.value)));
  if (!at(plan, index).isGrid())
    std::erase_if(constants, [](const ConstructConstant &constant) {
      return std::ranges::find(kOfGrids, constant.name) != std::end(kOfGrids);
    });
  if (!at(plan, index).distances())
    std::erase_if(constants, [](const ConstructConstant &constant) {
      return std::ranges::find(kOfDistances, constant.name) != std::end(kOfDistances);
    });
  return constants;
}

} // namespace voxc
