// Printing of formats: canonical IR text, and strings of the grammar.
#include "voxc/IR/Format.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace voxc {
namespace {

std::string parameters(const Level &level) {
  std::string text;
  for (const std::uint32_t parameter : level.parameters)
    text += (text.empty() ? "(" : ", ") + std::to_string(parameter);
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
  const std::string text = printIr(storageFormat(format));
  return XXH3_64bits(text.data(), text.size());
}

} // namespace voxc
