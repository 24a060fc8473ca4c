// Reading FORMAT arguments.
#include "frontend/FormatArgument.h"

#include "voxc/Input/NumberedPaths.h"
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

bool looksLikeFile(const std::string &argument) {
  // Every level has its parameters in parentheses, and IR is in braces.
  return argument.find_first_of("({ \n") == std::string::npos &&
         argument.find_first_of("/.") != std::string::npos;
}

Expected<Format> readFormat(const std::string &argument) {
  if (argument == "-" || argument.ends_with(".vir"))
    return readFormatFile(argument);
  if (!looksLikeFile(argument))
    return parseFormat(argument);
  if (Expected<MappedFile> file = MappedFile::open(argument); !file && !namesFiles(argument))
    return file.error();
  return Error::input("'" + argument +
                      "' is no format; write one such as \"R(4,4,4) G(8)\", or name a .vir file");
}

} // namespace voxc::tool
