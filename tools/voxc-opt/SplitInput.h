// An input as the parts that are run one by one, and what a part begins with.
#pragma once

#include "voxc/Support/Diagnostic.h"

#include <string_view>
#include <vector>

namespace voxc::tool {

/// The line that divides parts, as mlir-opt has it.
inline constexpr std::string_view kSplitMarker = "// -----";

/// The parts between lines that are the marker and nothing else; each knows which line of the input its first
/// is. Parts of comments and blanks alone are left out.
std::vector<SourceText> splitInput(const SourceText &input);

/// Where the first word of a text stands, behind blanks and comments; empty if there is none.
SourceRange firstWord(std::string_view text);

/// True if a text is that of a plan.
bool isPlanText(std::string_view text);

} // namespace voxc::tool
