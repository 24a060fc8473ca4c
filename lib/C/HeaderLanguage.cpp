// The traversal as functions in a language of choice, in C.
#include "C/FormatHandle.h"
#include "voxc/Emit/Emit.h"
#include "voxc/Plan/Plan.h"
#include "voxc/Support/EnumText.h"

#include <cstring>

using namespace voxc;
using namespace voxc::c;

namespace {

std::string allLanguages() {
  std::string all;
  for (const std::string_view name : kEnumNames<HeaderLanguage>)
    all += (all.empty() ? "" : ", ") + std::string(name);
  return all;
}

/// The functions of a format. Errors: no possible name; a format that they cannot be of.
Expected<std::string> functionsOf(const Format &format, const char *name, HeaderLanguage language) {
  const auto asked = VOXC_TRY(makePlan(format));
  if (asked.stopsAboveVoxels())
    return Error::input("the functions of a header stop at voxels alone: leave out detail=cone");
  const auto plan = VOXC_TRY(makePlan(format, kHeaderPlan));
  if (const std::string problem = problemOf(plan, EmitTarget::Functions); !problem.empty())
    return Error::input(problem);
  const std::string chosen = name ? name : headerName(plan.layout);
  if (!isHeaderName(chosen))
    return Error::usage("a name has letters, digits and single underscores between them, unlike '" + chosen +
                        "'");
  return emitHeader(plan, chosen, language);
}

} // namespace

voxc_error *voxc_emit_header(const voxc_format *format, const char *name, char **text) {
  return voxc_emit_header_in(format, nullptr, name, text);
}

voxc_error *voxc_emit_header_in(const voxc_format *format, const char *language, const char *name,
                                char **text) {
  return guarded([&]() -> Expected<void> {
    const std::optional<HeaderLanguage> chosen =
        language ? fromString<HeaderLanguage>(language) : HeaderLanguage::Shared;
    if (!chosen)
      return Error::usage("there are no headers in '" + std::string(language) + "'; there are " +
                          allLanguages());
    const auto functions = VOXC_TRY(functionsOf(format->format, name, *chosen));
    *text = ::strdup(functions.c_str());
    if (!*text)
      throw std::bad_alloc();
    return {};
  });
}
