// The names that templates speak of.
#include "Names.h"

#include "FormatWords.h"
#include "KernelConstants.h"

#include "voxc/Layout/SlotKind.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace voxc {
namespace {

std::string count(int log2, std::string_view unit) {
  const std::int64_t number = std::int64_t{1} << log2;
  return std::to_string(number) + " " + std::string(unit) + (number == 1 ? "" : "s");
}

/// What each query is about, as the head of a kernel says it.
constexpr std::array<std::string_view, 4> kAnswers = {"first hits of rays with", "whether rays hit",
                                                      "whether points are in",
                                                      "the t of first hits of rays with"};

/// What the packets of a processor ask.
void addPackets(TemplateNames &names, const Plan &plan) {
  const bool isPaged = plan.addressing == Addressing::Paged;
  auto &holes = names.holes;
  holes["real"] = plan.steps == StepArithmetic::Float64 ? "double" : "float";
  holes["sixth-word"] = plan.outputs.face ? "lookups or words read, else a face" : "lookups or words read";
  holes["is-inside"] = plan.bounded ? "is_in_reach(traversal)" : "is_in_volume(traversal.cell)";
  holes["ray-words"] = plan.bounded ? "8" : "6";
  holes["granule-words"] = std::to_string(1 << plan.layout.log2Granule);
  holes["cut-short"] = isPaged ? "kernel.lacks_page ? DONE : YIELDED" : "YIELDED";
  holes["may-have-waited"] = isPaged ? "true" : "false";
  holes["waited-or"] = isPaged ? "waited || " : "";
}

} // namespace

void addName(TemplateNames &names, std::string_view constant, const ConstantValue &value) {
  std::string name;
  for (const char c : constant)
    name += c == '_' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (const bool *const condition = std::get_if<bool>(&value))
    names.conditions[name] = *condition;
  else
    names.holes[name] = std::visit([](auto number) { return std::to_string(number); }, value);
}

int firstLayer(const Layout &layout, std::size_t index) {
  int layers = 0;
  for (std::size_t i = 0; i < index; ++i)
    layers += std::max(layout.strata[i].depth, 1);
  return layers;
}

std::uint32_t headWords(const Stratum &stratum) {
  const std::uint64_t ofSlot = stratum.implied ? 0 : static_cast<std::uint64_t>(stratum.slotWords());
  return static_cast<std::uint32_t>(stratum.slots->leastWords(stratum) - ofSlot);
}

std::string_view answers(Query query) { return kAnswers[static_cast<std::size_t>(query)]; }

std::string intVector(Int3 v) {
  return "ivec3(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + ")";
}

TemplateNames planNames(const Plan &plan) {
  TemplateNames names;
  for (const PlanConstant &constant : planConstants())
    addName(names, constant.name, constant.of(plan));
  names.holes["FORMAT"] = plan.layout.format;
  names.holes["DIGEST"] = hexadecimal(plan.layout.storageDigest);
  names.holes["answers"] = answers(plan.query);
  addPackets(names, plan);
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
