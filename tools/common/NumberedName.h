// Names of files that are numbered: slice-###.png, or slice-%03d.png.
#pragma once

#include "voxc/Support/NumberedPath.h"

#include <optional>
#include <string>

namespace voxc::tool {

/// A pattern of `NumberedPath`, or one with some # in place of as many digits, of which nine at most count.
/// Nothing if the text has no such place, or two.
std::optional<NumberedPath> parseNumberedName(const std::string &text);

/// What the files of a path with %d or %03d are called: "slice" of slice-%03d.png, "ct" of ct/%d.png; may be
/// empty. Of a path without such a place its stem.
std::string stemOfNumbered(const std::string &path);

/// The pattern with %03d for three digits.
std::string asPercent(const NumberedPath &name);

} // namespace voxc::tool
