// Plans as text.
#include "voxc/Plan/Plan.h"

#include <array>

namespace voxc {
namespace {

constexpr std::array<std::string_view, 6> kDescents = {"index", "distance", "single",
                                                       "stack", "restart",  "unrolled"};
constexpr std::array<std::string_view, 2> kPredicates = {"exact", "float32"};
constexpr std::array<std::string_view, 2> kDetails = {"full", "cone"};
constexpr std::array<std::string_view, 3> kSharings = {"none", "sub-volume", "level"};

std::string cells(Int3 log2) {
  return "2^" + std::to_string(log2.x) + "x2^" + std::to_string(log2.y) + "x2^" + std::to_string(log2.z);
}

} // namespace

std::string_view toString(Descent descent) { return kDescents[static_cast<std::size_t>(descent)]; }
std::string_view toString(Predicate predicate) { return kPredicates[static_cast<std::size_t>(predicate)]; }
std::string_view toString(Detail detail) { return kDetails[static_cast<std::size_t>(detail)]; }
std::string_view toString(Sharing sharing) { return kSharings[static_cast<std::size_t>(sharing)]; }

std::string printPlan(const Plan &plan) {
  std::string text = "plan {\n  addressing " + std::string(toString(plan.addressing)) + "\n  predicate " +
                     std::string(toString(plan.predicate)) + "\n";
  if (plan.detail != Detail::Full)
    text += "  detail " + std::string(toString(plan.detail)) + "\n";
  for (const LevelPlan &level : plan.levels) {
    text += "  level " + std::to_string(level.number) + ": " + std::string(level.kind->name) + " cells " +
            cells(level.log2Size) + " of 2^" + std::to_string(level.log2CellSide) + " voxels, descent " +
            std::string(toString(level.descent));
    if (level.reach > 0)
      text += ", reach " + std::to_string(level.reach);
    if (level.sharing != Sharing::None)
      text += ", sharing " + std::string(toString(level.sharing));
    if (level.stops)
      text += ", stops";
    if (level.sampled)
      text += ", sampled";
    text += "\n";
  }
  return text + "}\n";
}

} // namespace voxc
