// Names and numbers that emitted text has in several places.
#include "Names.h"

#include "FormatWords.h"
#include "KernelConstants.h"

#include "voxc/Layout/SlotKind.h"

#include <algorithm>
#include <array>

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

} // namespace

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

std::string levelComment(const Plan &plan, std::size_t index) {
  const Stratum &stratum = plan.layout.strata[index];
  const Int3 size = stratum.log2Size();
  return "\n// Level " + std::to_string(index + 1) + ": " + stratum.level + ", " +
         std::to_string(1 << size.x) + " x " + std::to_string(1 << size.y) + " x " + count(size.z, "cell") +
         " of " + count(stratum.log2Cell, "voxel") + " a side.\n";
}

} // namespace voxc
