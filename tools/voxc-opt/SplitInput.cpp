// Dividing an input at its markers.
#include "SplitInput.h"

#include <algorithm>

namespace voxc::tool {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

bool isMarker(std::string_view line) {
  return line.starts_with(kSplitMarker) &&
         line.find_first_not_of(kBlanks, kSplitMarker.size()) == std::string_view::npos;
}

bool isEmpty(std::string_view text) { return firstWord(text).begin == text.size(); }

} // namespace

std::vector<SourceText> splitInput(const SourceText &input) {
  const std::string_view text = input.text;
  std::vector<SourceText> parts;
  std::size_t begin = 0, firstLine = input.firstLine, number = firstLine;
  const auto endPart = [&](std::size_t end) {
    if (const std::string_view part = text.substr(begin, end - begin); !isEmpty(part))
      parts.push_back({input.name, std::string(part), firstLine});
  };
  for (std::size_t line = 0; line < text.size(); ++number) {
    const std::size_t next = std::min(text.find('\n', line), text.size() - 1) + 1;
    if (isMarker(text.substr(line, next - line))) {
      endPart(line);
      begin = next;
      firstLine = number + 1;
    }
    line = next;
  }
  endPart(text.size());
  return parts;
}

SourceRange firstWord(std::string_view text) {
  std::size_t begin = std::min(text.find_first_not_of(kBlanks), text.size());
  while (text.substr(begin, 2) == "//")
    begin =
        std::min(text.find_first_not_of(kBlanks, std::min(text.find('\n', begin), text.size())), text.size());
  return {begin, std::min(text.find_first_of(kBlanks, begin), text.size())};
}

bool isPlanText(std::string_view text) {
  const SourceRange word = firstWord(text);
  return text.substr(word.begin, word.end - word.begin).starts_with("plan");
}

} // namespace voxc::tool
