// Templates: runtime files with named holes and conditions, from which generated text is made.
//
//     uint child_level_${N}(uint node, ivec3 cell, int height, out bool leaf) {
//     %if wide
//       ...
//     %else
//       ...
//     %end
//
// ${NAME} is replaced, in comments too. Lines that begin with %if NAME, %else and %end are left out, and so
// are those between them that do not apply; they nest. A name that nobody gave a meaning is an error, which
// voxc-check-templates finds when voxc is built.
#pragma once

#include "voxc/Support/EmbeddedFile.h"
#include "voxc/Support/Error.h"

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace voxc {

/// What the names of a template stand for.
struct TemplateNames {
  std::map<std::string, std::string, std::less<>> holes;
  std::map<std::string, bool, std::less<>> conditions;
};

/// The text with its holes filled and its conditions resolved. Error: what is wrong, and in which line.
Expected<std::string> fillTemplate(std::string_view text, const TemplateNames &names);

/// The same for a runtime file. What is wrong becomes an #error line in the text: no compiler takes it
/// silently.
std::string fillFile(std::span<const EmbeddedFile> files, std::string_view path, const TemplateNames &names);

/// The text of a runtime file as it is, which must exist.
std::string_view runtimeFile(std::span<const EmbeddedFile> files, std::string_view path);

} // namespace voxc
