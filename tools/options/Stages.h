// Where the time of a run went.
#pragma once

#include "common/Json.h"

#include <string>

namespace voxc::tool {

/// Adds `total_seconds`, what the user has waited so far, and `stages`: the seconds of each stage that took
/// some, by its name, with what is left of the total as `rest`.
void addStages(Json &figures, double totalSeconds);

/// "11.24 s: format 2.10, input 0.31, ..., rest 0.12": the parts add up to the total. "" without stages.
std::string stagesText(const Json &figures);

} // namespace voxc::tool
