// Reading FORMAT arguments.
#include "frontend/FormatArgument.h"

#include "voxc/Support/File.h"

#include <iostream>
#include <iterator>

namespace voxc::tool {

Expected<Format> readFormatFile(const std::string &path) {
  if (path == "-") {
    const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
    return parseFormat(text, "<stdin>");
  }
  Expected<std::string> text = readTextFile(path);
  if (!text)
    return text.error();
  return parseFormat(*text, path);
}

Expected<Format> readFormat(const std::string &argument) {
  if (argument == "-" || argument.ends_with(".vir"))
    return readFormatFile(argument);
  return parseFormat(argument);
}

} // namespace voxc::tool
