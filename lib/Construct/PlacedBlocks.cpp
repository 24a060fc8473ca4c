// Where the blocks of a volume went.
#include "PlacedBlocks.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace voxc {
namespace {

constexpr int kLog2Least = 10;
constexpr int kBits = 64;

} // namespace

void PlacedBlocks::clear() {
  const int log2 = std::max(kLog2Least, static_cast<int>(std::bit_width(count_)));
  entries_ = std::vector<Entry>(std::size_t{1} << log2);
  shift_ = kBits - log2;
  count_ = 0;
}

void PlacedBlocks::place(std::uint64_t word, const Placed &placed) {
  if (3 * (count_ + 1) > 2 * entries_.size())
    grow();
  Entry &entry = entries_[slotOf(word)];
  count_ += entry.word == 0 ? 1 : 0;
  entry = {word, placed};
}

void PlacedBlocks::grow() {
  const std::vector<Entry> before = std::exchange(entries_, std::vector<Entry>(2 * entries_.size()));
  --shift_;
  for (const Entry &entry : before)
    if (entry.word != 0)
      entries_[slotOf(entry.word)] = entry;
}

} // namespace voxc
