// The FORMAT argument of the tools: a format string, a .vir file, or '-' for standard input.
#pragma once

#include "voxc/IR/Format.h"
#include "voxc/Support/Error.h"

#include <string>

namespace voxc::tool {

/// True of text that can be no format and has a folder or an ending: someone means a file.
bool looksLikeFile(const std::string &argument);

/// Reads `argument` as a format. Errors name the text as "format", the file, or "<stdin>"; of what looks like
/// a file they say that it cannot be read, or is no format.
Expected<Format> readFormat(const std::string &argument);

/// Reads a file that holds IR or a format string; '-' is standard input.
Expected<Format> readFormatFile(const std::string &path);

} // namespace voxc::tool
