// Texts of a page with holes: `${NAME}`.
#pragma once

#include "voxc/Support/Error.h"

#include <map>
#include <string>
#include <string_view>

namespace voxc::page {

/// What stands in place of `${NAME}`.
using Holes = std::map<std::string, std::string, std::less<>>;

/// The text with its holes filled, also in comments. Error: a hole that nobody named.
Expected<std::string> fill(std::string_view text, const Holes &holes);

} // namespace voxc::page
