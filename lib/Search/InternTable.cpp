// Numbers for lists of words.
#include "InternTable.h"

#include <algorithm>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace voxc {
namespace {

constexpr std::size_t kSmallest = 64;

} // namespace

std::uint32_t InternTable::intern(std::span<const std::uint32_t> list, std::vector<std::uint32_t> &words,
                                  std::vector<std::uint64_t> &begins) {
  if (2 * used_ >= entries_.size())
    grow();
  const auto hash = static_cast<std::uint32_t>(XXH3_64bits(list.data(), list.size_bytes()));
  const std::size_t last = entries_.size() - 1;
  for (std::size_t at = hash & last;; at = (at + 1) & last) {
    Entry &entry = entries_[at];
    if (entry.number == 0) {
      begins.push_back(words.size());
      words.insert(words.end(), list.begin(), list.end());
      entry = {static_cast<std::uint32_t>(begins.size()), hash};
      ++used_;
      return entry.number - 1;
    }
    if (entry.hash != hash)
      continue;
    const std::uint64_t begin = begins[entry.number - 1];
    if (words.size() - begin >= list.size() &&
        std::equal(list.begin(), list.end(), words.begin() + static_cast<std::ptrdiff_t>(begin)))
      return entry.number - 1;
  }
}

void InternTable::grow() {
  std::vector<Entry> old(std::max(kSmallest, 2 * entries_.size()));
  old.swap(entries_);
  const std::size_t last = entries_.size() - 1;
  for (const Entry &entry : old) {
    if (entry.number == 0)
      continue;
    std::size_t at = entry.hash & last;
    while (entries_[at].number != 0)
      at = (at + 1) & last;
    entries_[at] = entry;
  }
}

} // namespace voxc
