// Formats with passes in a line.
#include "view/FormatText.h"

#include "voxc/Passes/Pass.h"

namespace voxc::view {
namespace {

constexpr std::string_view kBlanks = " \t\r\n", kQuotes = "'\"";

std::string_view trim(std::string_view text, std::string_view what) {
  const std::size_t begin = text.find_first_not_of(what);
  return begin == std::string_view::npos ? std::string_view{}
                                         : text.substr(begin, text.find_last_not_of(what) + 1 - begin);
}

} // namespace

FormatText parseFormatText(std::string_view text) {
  constexpr std::string_view kMark = "--";
  FormatText result;
  const std::size_t first = text.find(kMark);
  result.format = trim(trim(trim(text.substr(0, first), kBlanks), kQuotes), kBlanks);
  while (text.find(kMark) != std::string_view::npos) {
    text.remove_prefix(text.find(kMark) + kMark.size());
    // A name may hold dashes; the next pass begins after a blank.
    const std::string_view name = text.substr(0, text.find_first_of(kBlanks));
    result.passes.emplace_back(name);
    text.remove_prefix(name.size());
  }
  return result;
}

std::string formatText(const std::string &format, std::span<const std::string> passes) {
  std::string text = format;
  for (const std::string &pass : passes)
    text += " --" + pass;
  return text;
}

std::string formatText(const Format &format) {
  std::string text = toString(format);
  const Expected<Format> plain = parseFormat(text);
  if (plain && *plain == format)
    return text;
  std::string line;
  for (const char c : printIr(format))
    if (const char blank = c == '\n' ? ' ' : c; blank != ' ' || !line.ends_with(' '))
      line += blank;
  return std::string(trim(line, kBlanks));
}

std::string spelledText(std::string_view text) {
  const FormatText parts = parseFormatText(text);
  const Expected<Format> format = parseFormat(parts.format);
  return format ? formatText(formatText(*format), parts.passes) : std::string(text);
}

Expected<Format> readFormatText(const FormatText &text) {
  Expected<Format> format = parseFormat(text.format);
  if (!format)
    return format;
  if (Expected<void> passed = runPasses(*format, text.passes); !passed)
    return passed.error();
  return format;
}

} // namespace voxc::view
