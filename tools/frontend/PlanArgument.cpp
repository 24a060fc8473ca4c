// Reading arguments that are formats or plans.
#include "frontend/PlanArgument.h"

#include "frontend/FormatArgument.h"

#include "voxc/Support/File.h"

#include <iostream>
#include <iterator>

namespace voxc::tool {
namespace {

using FormatOrPlan = Expected<std::variant<Format, Plan>>;

template <typename Parsed> FormatOrPlan either(Expected<Parsed> parsed) {
  if (!parsed)
    return parsed.error();
  return std::variant<Format, Plan>(std::move(*parsed));
}

/// True if a file begins as a plan does; what cannot be read does not.
bool holdsPlan(const std::string &path) {
  const Expected<MappedFile> file = MappedFile::open(path);
  return file && isPlanText({reinterpret_cast<const char *>(file->bytes().data()), file->bytes().size()});
}

} // namespace

Expected<std::variant<Format, Plan>> readFormatOrPlan(const std::string &argument) {
  if (argument == "-") {
    const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
    return isPlanText(text) ? either(parseFinishedPlan(text, "<stdin>"))
                            : either(parseFormat(text, "<stdin>"));
  }
  if (isPlanText(argument))
    return either(parseFinishedPlan(argument, "plan"));
  if (!looksLikeFile(argument) || !holdsPlan(argument))
    return either(readFormat(argument));
  auto text = VOXC_TRY(readTextFile(argument));
  return either(parseFinishedPlan(text, argument));
}

} // namespace voxc::tool
