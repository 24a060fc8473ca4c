// Formats with passes in a line.
#include "view/FormatText.h"

#include "voxc/Passes/Pass.h"

#include <algorithm>
#include <optional>
#include <set>

namespace voxc::view {
namespace {

constexpr std::string_view kBlanks = " \t\r\n", kQuotes = "'\"";

std::string_view trim(std::string_view text, std::string_view what) {
  const std::size_t begin = text.find_first_not_of(what);
  return begin == std::string_view::npos ? std::string_view{}
                                         : text.substr(begin, text.find_last_not_of(what) + 1 - begin);
}

/// All that is set on a format and its levels, each as a text of its own.
std::set<std::string> choicesOf(const Format &format) {
  std::set<std::string> choices;
  const auto add = [&choices](std::size_t place, const AttributeSet &set, AttributeKinds kinds) {
    for (const AttributeKind *kind : kinds)
      if (set.value(*kind) != kind->values.front())
        choices.insert(std::to_string(place) + ":" + std::string(kind->name) + "=" +
                       std::string(set.value(*kind)));
  };
  add(0, format.attributes, formatAttributes());
  for (std::size_t i = 0; i < format.levels.size(); ++i)
    add(i + 1, format.levels[i].attributes, format.levels[i].kind->attributes);
  return choices;
}

/// Passes are repeated so often at most: `granules` counts from one word to 2^8 of them.
constexpr int kMostRepeats = 8;

/// Goes by one pass from `format` towards `wanted`: whatever is set afterwards, and all that was set before,
/// is what `wanted` has, too. The names that did it, or none.
std::vector<std::string> approach(Format &format, const Format &wanted, const std::string &name) {
  const std::set<std::string> choices = choicesOf(wanted), had = choicesOf(format);
  Format next = format;
  for (int times = 1; times <= kMostRepeats; ++times) {
    const Format before = next;
    if (!runPasses(next, std::span(&name, 1)) || toString(next) != toString(wanted) || next == before)
      return {};
    const std::set<std::string> has = choicesOf(next);
    if (has.size() > had.size() && std::ranges::includes(has, had) && std::ranges::includes(choices, has)) {
      format = std::move(next);
      return std::vector<std::string>(std::size_t(times), name);
    }
  }
  return {};
}

/// A pass by itself, and with each number that it takes.
std::vector<std::string> spellingsOf(const Pass &pass) {
  std::vector<std::string> names{std::string(pass.name)};
  if (pass.number)
    for (int number = pass.number->least; number <= pass.number->most; ++number)
      names.push_back(std::string(pass.name) + "=" + std::to_string(number));
  return names;
}

/// The passes that make `wanted` of its format string, if there are such.
std::optional<std::vector<std::string>> passesThatGive(const Format &wanted) {
  Expected<Format> format = parseFormat(toString(wanted));
  if (!format)
    return std::nullopt;
  std::vector<std::string> names;
  // Some passes change a format only after others.
  std::size_t before = 0;
  do {
    before = names.size();
    for (const Pass &pass : passes())
      for (const std::string &name : spellingsOf(pass)) {
        const std::vector<std::string> taken = approach(*format, wanted, name);
        names.insert(names.end(), taken.begin(), taken.end());
      }
  } while (names.size() != before);
  return *format == wanted ? std::optional(names) : std::nullopt;
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
  if (const auto passes = passesThatGive(format))
    return formatText(toString(format), *passes);
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
  auto format = VOXC_TRY(parseFormat(text.format));
  VOXC_TRY(runPasses(format, text.passes));
  return format;
}

} // namespace voxc::view
