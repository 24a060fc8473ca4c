// Printing of formats: canonical IR text, and strings of the grammar.
#include "voxc/IR/Format.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace voxc {
namespace {

/// Without defaults at the end.
std::string parameters(const Level &level) {
  std::size_t written = level.parameters.size();
  while (written > 0 && level.kind->parameters[written - 1].defaultValue == level.parameters[written - 1])
    --written;
  std::string text;
  for (std::size_t i = 0; i < written; ++i)
    text += (text.empty() ? "(" : ", ") + std::to_string(level.parameters[i]);
  return text + ")";
}

} // namespace

std::string printIr(const Format &format) {
  std::string text = "format" + printAttributes(format.attributes, formatAttributes()) + " {\n";
  for (std::size_t i = 0; i < format.levels.size(); ++i) {
    const Level &level = format.levels[i];
    text += "  level " + std::to_string(i + 1) + ": " + std::string(level.kind->name) + parameters(level) +
            printAttributes(level.attributes, level.kind->attributes) + "\n";
  }
  return text + "}\n";
}

std::string toString(const Format &format) {
  std::string text;
  for (const Level &level : format.levels)
    text += (text.empty() ? "" : " ") + std::string(1, level.kind->letter) + parameters(level);
  return text;
}

std::uint64_t storageDigest(const Format &format) {
  const std::string text = printIr(canonicalFormat(format));
  return XXH3_64bits(text.data(), text.size());
}

} // namespace voxc
