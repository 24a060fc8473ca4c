// Looking at all vertices of a text before the first is read.
#include "Mesh/Obj/VertexNumbers.h"

#include "Support/Text.h"

#include <array>

namespace voxc {

bool haveWeights(std::string_view text) {
  TextLines lines(text);
  while (const auto line = lines.next()) {
    std::string_view rest = *line;
    if (const std::string_view word = takeWord(rest); word != "v" && word != "V")
      continue;
    std::array<std::string_view, 7> words;
    for (std::string_view &word : words)
      word = takeWord(rest);
    if (!words[6].empty() && !words[6].starts_with('#') && parseNumber(words[3]) != 1.0)
      return false;
  }
  return true;
}

} // namespace voxc
