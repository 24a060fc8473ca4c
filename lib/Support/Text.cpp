// Cutting text into words and lines.
#include "Support/Text.h"

#include <algorithm>
#include <array>
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

std::string printable(std::string_view text) {
  std::string printed(text);
  std::ranges::replace_if(printed, [](unsigned char c) { return c < ' ' || c == 127; }, '?');
  return printed;
}

std::string counted(std::uint64_t count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

std::string countedAre(std::uint64_t count, std::string_view noun) {
  return counted(count, noun) + (count == 1 ? " is" : " are");
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

namespace {

/// True if the first characters of `text`, `width` bytes each, are ASCII, whose byte is the one at `place`.
bool isAsciiOf(std::string_view text, std::size_t width, std::size_t place) {
  constexpr std::size_t kCharacters = 8;
  std::size_t count = 0;
  for (; count < kCharacters && (count + 1) * width <= text.size(); ++count)
    for (std::size_t i = 0; i < width; ++i) {
      const char c = text[count * width + i];
      if (i == place ? !isBlank(c) && (c < ' ' || c > '~') : c != 0)
        return false;
    }
  return count >= 2;
}

struct WideRow {
  std::string_view name;
  std::string_view mark;
  std::size_t place; ///< Of the byte of ASCII; there are as many bytes as in the mark.
};

} // namespace

std::string_view wideEncoding(std::string_view text) {
  using namespace std::string_view_literals;
  static constexpr std::array<WideRow, 4> kRows{{{"UTF-32", "\xff\xfe\0\0"sv, 0},
                                                 {"UTF-32", "\0\0\xfe\xff"sv, 3},
                                                 {"UTF-16", "\xff\xfe"sv, 0},
                                                 {"UTF-16", "\xfe\xff"sv, 1}}};
  for (const WideRow &row : kRows)
    if (isAsciiOf(text.substr(text.starts_with(row.mark) ? row.mark.size() : 0), row.mark.size(), row.place))
      return row.name;
  return {};
}

std::string isWideText(std::string_view encoding) {
  return "it is " + std::string(encoding) + " text, which is not read; save it as UTF-8";
}

std::string_view TextLines::takeLine() {
  ++number_;
  const std::size_t begin = text_.size() - rest_.size();
  // A text without line feeds is searched for one once.
  if (lineFeed_ < begin || number_ == 1)
    lineFeed_ = std::min(text_.find('\n', begin), text_.size());
  std::string_view line = text_.substr(begin, lineFeed_ - begin);
  line = line.substr(0, line.find('\r'));
  rest_.remove_prefix(line.size());
  rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, rest_.size()));
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
