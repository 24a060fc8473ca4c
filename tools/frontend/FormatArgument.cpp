// Reading FORMAT arguments.
#include "frontend/FormatArgument.h"

#include "voxc/Input/NumberedPaths.h"
#include "voxc/Plan/Plan.h"
#include "voxc/Support/File.h"

#include <iostream>
#include <iterator>

namespace voxc::tool {
namespace {

/// Both kinds of plans are no formats, and their text would be many errors.
constexpr std::string_view kBuildPlanWords = "voxc build plan ";

Expected<Format> parseFormatOf(std::string_view text, const std::string &name) {
  if (isPlanText(text))
    return Error::input(
        "'" + name +
        "' is the plan of a kernel, from which voxc compile and voxc-opt go on; here a format is wanted");
  if (text.starts_with(kBuildPlanWords))
    return Error::input("'" + name +
                        "' is a build plan, which voxc submit carries out; here a format is wanted");
  return parseFormat(text, name);
}

/// What is wrong with a file of another kind.
Error problemOfFile(const std::string &path) {
  const Expected<MappedFile> file = MappedFile::open(path);
  if (!file && !namesFiles(path))
    return file.error();
  if (file) {
    const std::string_view text(reinterpret_cast<const char *>(file->bytes().data()), file->bytes().size());
    if (isPlanText(text) || text.starts_with(kBuildPlanWords))
      return parseFormatOf(text, path).error();
  }
  return Error::input("'" + path +
                      "' is no format; write one such as \"R(4,4,4) G(8)\", or name a .vir file");
}

} // namespace

Expected<Format> readFormatFile(const std::string &path) {
  if (path == "-") {
    const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
    return parseFormatOf(text, "<stdin>");
  }
  auto text = VOXC_TRY(readTextFile(path));
  return parseFormatOf(text, path);
}

bool looksLikeFile(const std::string &argument) {
  // Every level has its parameters in parentheses, and IR is in braces.
  return argument.find_first_of("({ \n") == std::string::npos &&
         argument.find_first_of("/.") != std::string::npos;
}

Expected<Format> readFormat(const std::string &argument) {
  if (argument == "-" || argument.ends_with(".vir"))
    return readFormatFile(argument);
  return looksLikeFile(argument) ? problemOfFile(argument) : parseFormat(argument);
}

} // namespace voxc::tool
