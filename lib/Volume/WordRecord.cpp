// Printing and reading the record of words.
#include "WordRecord.h"

#include <charconv>
#include <cstdio>

namespace voxc {
namespace {

constexpr std::string_view kMark = "\nwords=";
constexpr std::size_t kHexDigits = 16;

std::string digitsOf(std::uint64_t count) {
  char digits[kHexDigits + 1];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(count));
  return digits;
}

/// "0000000000000010,00000000000001a4": all numbers, or none if it is no such text.
std::vector<std::uint64_t> numbersIn(std::string_view text) {
  std::vector<std::uint64_t> numbers;
  for (std::size_t at = 0; at < text.size(); at += kHexDigits + 1) {
    const std::string_view digits = text.substr(at, kHexDigits);
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number, 16);
    const bool isLast = at + kHexDigits == text.size();
    if (digits.size() != kHexDigits || error != std::errc{} || end != digits.data() + kHexDigits ||
        !(isLast || (at + kHexDigits + 1 < text.size() && text[at + kHexDigits] == ',')))
      return {};
    numbers.push_back(number);
  }
  return numbers;
}

} // namespace

std::string textWithRecord(const VolumeInfo &info) {
  if (!info.wordCounts)
    return info.provenance;
  std::string text = info.provenance + std::string(kMark);
  for (const std::uint64_t level : info.wordCounts->levels)
    text += digitsOf(level) + ",";
  return text + digitsOf(info.wordCounts->values);
}

void readRecord(std::string_view text, VolumeInfo &info) {
  const std::size_t mark = text.rfind(kMark);
  if (mark != std::string_view::npos)
    if (auto numbers = numbersIn(text.substr(mark + kMark.size()));
        numbers.size() == info.format.levels.size() + 1) {
      info.wordCounts = WordCounts{{numbers.begin(), numbers.end() - 1}, numbers.back()};
      text = text.substr(0, mark);
    }
  info.provenance = text;
}

} // namespace voxc
