// Reading and writing of lists of numbers.
#include "cluster/NumberList.h"

#include <charconv>

namespace voxc::tool::cluster {
namespace {

std::optional<std::uint64_t> takeNumber(std::string_view &text) {
  std::uint64_t number = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failure != std::errc())
    return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

} // namespace

std::optional<std::vector<std::uint64_t>> parseNumberList(std::string_view text, std::uint64_t limit) {
  std::vector<std::uint64_t> numbers;
  for (bool isFirst = true; isFirst || !text.empty(); isFirst = false) {
    if (!isFirst && text.front() != ',')
      return std::nullopt;
    text.remove_prefix(isFirst ? 0 : 1);
    const auto first = takeNumber(text);
    auto last = first;
    if (text.starts_with('-')) {
      text.remove_prefix(1);
      last = takeNumber(text);
    }
    if (!first || !last || *last < *first || *last >= limit)
      return std::nullopt;
    for (std::uint64_t number = *first; number <= *last; ++number)
      numbers.push_back(number);
  }
  return numbers;
}

std::string numberListText(const std::vector<std::uint64_t> &numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1)
      ++last;
    text += (text.empty() ? "" : ",") + std::to_string(numbers[i]);
    if (last > i)
      text += "-" + std::to_string(numbers[last]);
    i = last + 1;
  }
  return text;
}

} // namespace voxc::tool::cluster
