// The FORMAT argument of tools that also go on from a plan: its text, or a file with it.
#pragma once

#include "voxc/IR/Format.h"
#include "voxc/Plan/Plan.h"
#include "voxc/Support/Error.h"

#include <string>
#include <variant>

namespace voxc::tool {

/// Reads `argument` as a finished plan where it is the text of a plan or a file with such, '-' being standard
/// input; else as `readFormat` does.
Expected<std::variant<Format, Plan>> readFormatOrPlan(const std::string &argument);

} // namespace voxc::tool
