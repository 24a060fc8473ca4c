// Cutting text into words and lines.
#include "Support/Text.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>

namespace voxc {

namespace {

bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Rare: too large for a double, or so close to 0 that it is 0.
double parseExtreme(std::string_view word) { return std::strtod(std::string(word).c_str(), nullptr); }

std::string_view withoutPlus(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

} // namespace

std::string_view takeWord(std::string_view &text) {
  const auto begin = std::find_if_not(text.begin(), text.end(), isBlank);
  const auto end = std::find_if(begin, text.end(), isBlank);
  const std::string_view word(begin, end);
  text = std::string_view(end, text.end());
  return word;
}

std::string_view trimmed(std::string_view text) {
  const auto begin = std::find_if_not(text.begin(), text.end(), isBlank);
  while (text.end() != begin && isBlank(text.back()))
    text.remove_suffix(1);
  return {begin, text.end()};
}

std::string lowerCase(std::string_view text) {
  std::string result(text);
  for (char &c : result)
    if (c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return result;
}

std::optional<double> parseNumber(std::string_view word) {
  word = withoutPlus(word);
  double value = 0;
  const auto parsed = std::from_chars(word.data(), word.data() + word.size(), value);
  if (parsed.ptr != word.data() + word.size() || parsed.ec == std::errc::invalid_argument)
    return std::nullopt;
  return parsed.ec == std::errc::result_out_of_range ? parseExtreme(word) : value;
}

std::optional<std::int64_t> parseInteger(std::string_view word) {
  word = withoutPlus(word);
  std::int64_t value = 0;
  const auto parsed = std::from_chars(word.data(), word.data() + word.size(), value);
  if (parsed.ptr != word.data() + word.size() || parsed.ec != std::errc())
    return std::nullopt;
  return value;
}

std::string_view TextLines::takeLine() {
  ++number_;
  const std::size_t length = std::min(rest_.find('\n'), rest_.size());
  std::string_view line = rest_.substr(0, length);
  rest_.remove_prefix(std::min(length + 1, rest_.size()));
  if (line.ends_with('\r'))
    line.remove_suffix(1);
  return line;
}

std::optional<std::string_view> TextLines::next() {
  if (rest_.empty())
    return std::nullopt;
  std::string_view line = takeLine();
  if (!line.ends_with('\\'))
    return line;
  joined_.clear();
  while (line.ends_with('\\')) {
    joined_ += line.substr(0, line.size() - 1);
    joined_ += ' ';
    line = rest_.empty() ? std::string_view() : takeLine();
  }
  joined_ += line;
  return joined_;
}

} // namespace voxc
