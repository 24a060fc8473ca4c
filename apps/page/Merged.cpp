// Two texts that are mostly alike as one: their longest common subsequence of lines stands once.
#include "page/Merged.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace voxc::page {
namespace {

std::vector<std::string_view> linesOf(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    lines.push_back(text.substr(0, text.find('\n')));
    text.remove_prefix(std::min(lines.back().size() + 1, text.size()));
  }
  return lines;
}

} // namespace

std::string merged(std::string_view first, std::string_view second) {
  const std::vector<std::string_view> a = linesOf(first), b = linesOf(second);
  // common[i][j]: of the longest subsequence that lines i and j and those behind them have in common.
  std::vector common(a.size() + 1, std::vector<std::uint32_t>(b.size() + 1));
  for (std::size_t i = a.size(); i-- > 0;)
    for (std::size_t j = b.size(); j-- > 0;)
      common[i][j] = a[i] == b[j] ? common[i + 1][j + 1] + 1 : std::max(common[i + 1][j], common[i][j + 1]);
  std::string result;
  const auto add = [&result](char mark, std::string_view line) {
    result += mark;
    result += line;
    result += '\n';
  };
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    if (i < a.size() && j < b.size() && a[i] == b[j])
      add(' ', (++j, a[i++]));
    else if (j == b.size() || (i < a.size() && common[i + 1][j] >= common[i][j + 1]))
      add('-', a[i++]);
    else
      add('+', b[j++]);
  }
  return result;
}

} // namespace voxc::page
