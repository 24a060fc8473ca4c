// The names of what a kernel is asked.
#include "QuestionNames.h"

#include <array>
#include <cstddef>
#include <string_view>

namespace voxc {
namespace {

/// What each query is about, as the head of a kernel says it.
constexpr std::array<std::string_view, 4> kAnswers = {"first hits of rays with", "whether rays hit",
                                                      "whether points are in",
                                                      "the t of first hits of rays with"};

/// What is asked of a kernel, and how its functions hand on no more than that.
void addQuestion(TemplateNames &names, const Plan &plan) {
  const Outputs &outputs = plan.outputs;
  const bool isPoint = plan.isOfPoints();
  const bool hasArrival = outputs.t || outputs.face;
  names.holes["answers"] = kAnswers[static_cast<std::size_t>(plan.query)];
  names.holes["sixth-word"] = outputs.face ? "lookups or words read, else a face" : "lookups or words read";
  names.conditions["point"] = isPoint;
  names.conditions["arrival"] = hasArrival;
  names.conditions["axis"] = hasArrival || plan.bounded;
  names.conditions["voxel"] = outputs.voxel;
  names.conditions["t"] = outputs.t;
  names.conditions["face"] = outputs.face;
  names.conditions["colour"] = storesValue(outputs);
}

/// Where a ray lies, and how its bounds are kept.
void addBounds(TemplateNames &names, const Plan &plan) {
  const bool bounded = plan.bounded;
  auto &holes = names.holes;
  names.conditions["bounded"] = bounded;
  holes["is-inside"] = bounded ? "is_in_reach(walk)" : "is_in_volume(walk.cell)";
  holes["ray-words"] = bounded ? "8" : "6";
}

} // namespace

void addQuestionNames(TemplateNames &names, const Plan &plan) {
  addQuestion(names, plan);
  addBounds(names, plan);
}

} // namespace voxc
