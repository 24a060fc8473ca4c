// Lists of formats, as files or on the command line.
#pragma once

#include "voxc/Support/Error.h"

#include <string>
#include <vector>

namespace voxc::tool {

/// A line of a list. The format is a text that may be wrong: its cell then fails.
struct FormatLine {
  std::string label; ///< What stands before a tab, or "".
  std::string text;

  bool operator==(const FormatLine &) const = default;
};

/// Reads a list: "F;F;F" if there is a parenthesis or brace in it, for which every format has one, else the
/// path of a file with a format a line, `label<TAB>format` or the format alone; empty lines and those that
/// begin with # are skipped. Errors (`Input`): no such file, no format in the list, a label without a format,
/// a line of more than 4,096 characters or with control characters, more than 10,000 formats.
Expected<std::vector<FormatLine>> readFormatList(const std::string &argument);

} // namespace voxc::tool
