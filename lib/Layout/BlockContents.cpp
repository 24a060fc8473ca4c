// Finding the runs and the palette of a block, and counting its runs.
#include "BlockContents.h"

#include <algorithm>
#include <bit>

namespace voxc {

std::uint32_t BlockContents::indexOf(std::uint32_t value) const {
  return static_cast<std::uint32_t>(std::ranges::find(palette, value) - palette.begin());
}

BlockContents contentsOf(std::span<const std::uint32_t> values) {
  BlockContents contents;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0 && values[i] == values[i - 1])
      continue;
    contents.mask[i / 32] |= 1u << i % 32;
    contents.begins.push_back(static_cast<std::uint32_t>(i));
    contents.runs.push_back(values[i]);
    if (std::ranges::find(contents.palette, values[i]) == contents.palette.end())
      contents.palette.push_back(values[i]);
  }
  return contents;
}

std::uint64_t runsBegun(const WordReader &words, std::uint64_t mask, std::uint64_t count) {
  std::uint64_t begun = 0;
  for (std::uint64_t i = 0; i < kRunWords; ++i) {
    const std::uint64_t left = std::clamp<std::uint64_t>(count, 32 * i, 32 * i + 32) - 32 * i;
    const std::uint64_t bits = (std::uint64_t{1} << left) - 1;
    begun += static_cast<std::uint64_t>(std::popcount(words[mask + i] & bits));
  }
  return begun;
}

} // namespace voxc
