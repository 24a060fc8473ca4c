// What voxc suggest says.
#pragma once

#include "choosing/Suggestion.h"

#include "common/Json.h"

#include <string>

namespace voxc::tool {

/// The choice, two lines of why, and the command that builds it; with `all`, a table of the frontier.
std::string suggestReport(const Suggestion &suggestion, bool all);

/// Adds every format that was looked at, the frontier marked, as JSON.
void addSuggestFigures(Json &figures, const Suggestion &suggestion);

} // namespace voxc::tool
