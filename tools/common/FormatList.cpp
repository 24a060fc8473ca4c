// Reading lists of formats.
#include "common/FormatList.h"

#include "voxc/Support/File.h"

#include <algorithm>
#include <string_view>

namespace voxc::tool {
namespace {

constexpr std::size_t kMaxLine = 4096;
constexpr std::size_t kMaxFormats = 10000;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t begin = std::min(text.find_first_not_of(kBlanks), text.size());
  return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

bool isControl(char c) { return static_cast<unsigned char>(c) < ' ' && c != '\t' && c != '\r'; }

/// The line's format, or what is wrong with it.
Expected<FormatLine> parseLine(std::string_view line) {
  if (line.size() > kMaxLine)
    return Error::input("a line should have at most " + std::to_string(kMaxLine) + " characters");
  if (std::ranges::any_of(line, isControl))
    return Error::input("a line should be text; there is a control character in it");
  const std::size_t tab = line.find('\t');
  if (tab == std::string_view::npos)
    return FormatLine{"", std::string(trimmed(line))};
  FormatLine entry{std::string(trimmed(line.substr(0, tab))), std::string(trimmed(line.substr(tab + 1)))};
  if (entry.text.empty())
    return Error::input("label '" + entry.label + "' has no format behind it");
  return entry;
}

/// The lines of a text; `where` names it, and with a number behind it a line.
Expected<std::vector<FormatLine>> parseList(std::string_view text, char separator, const std::string &where) {
  std::vector<FormatLine> entries;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find(separator), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (trimmed(line).empty() || line.starts_with('#'))
      continue;
    Expected<FormatLine> entry = parseLine(line);
    if (!entry)
      return Error::input(where + ":" + std::to_string(number) + ": " + entry.error().message);
    entries.push_back(std::move(*entry));
    if (entries.size() > kMaxFormats)
      return Error::input(where + " has more than " + std::to_string(kMaxFormats) + " formats");
  }
  if (entries.empty())
    return Error::input(where +
                        " has no formats; write one a line, with a label and a tab before it if you like");
  return entries;
}

} // namespace

Expected<std::vector<FormatLine>> readFormatList(const std::string &argument) {
  constexpr std::string_view kSignsOfAFormat = "({;";
  if (argument.find_first_of(kSignsOfAFormat) != std::string::npos)
    return parseList(argument, ';', "--formats");
  const Expected<std::string> text = readTextFile(argument);
  if (!text)
    return Error{text.error().kind,
                 "--formats '" + argument + "' is neither a format nor a list: " + text.error().message};
  return parseList(*text, '\n', argument);
}

} // namespace voxc::tool
