// An open-addressing hash table with linear probing, at most three quarters full.
#include "NodeMap.h"

#include <algorithm>
#include <utility>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace voxc {
namespace {

constexpr std::uint64_t kEntriesBetweenRelief = 1024;

bool isAt(std::span<const std::uint32_t> node, std::span<const std::uint32_t> written, std::uint64_t offset) {
  return node.size() <= written.size() - offset &&
         std::equal(node.begin(), node.end(), written.begin() + static_cast<std::ptrdiff_t>(offset));
}

} // namespace

std::uint32_t NodeMap::hashOf(std::span<const std::uint32_t> node) {
  return static_cast<std::uint32_t>(XXH3_64bits(node.data(), node.size_bytes()) >> 32);
}

std::uint32_t NodeMap::hashOf(std::uint32_t word) {
  // Each step can be undone, so that different words stay different.
  word ^= word >> 16;
  word *= 0x85ebca6bu;
  word ^= word >> 13;
  word *= 0xc2b2ae35u;
  return word ^ word >> 16;
}

std::optional<std::uint32_t> NodeMap::find(std::uint32_t hash) const {
  if (used_ == 0)
    return std::nullopt;
  const Entry *entries = entries_.data();
  const std::uint64_t mask = (std::uint64_t{1} << log2Size_) - 1;
  for (std::uint64_t at = home(hash); entries[at].offset != 0; at = (at + 1) & mask)
    if (entries[at].hash == hash)
      return entries[at].offset;
  return std::nullopt;
}

std::optional<std::uint32_t> NodeMap::find(std::uint32_t hash, std::span<const std::uint32_t> node,
                                           std::span<const std::uint32_t> written) const {
  if (used_ == 0)
    return std::nullopt;
  const Entry *entries = entries_.data();
  const std::uint64_t mask = (std::uint64_t{1} << log2Size_) - 1;
  for (std::uint64_t at = home(hash); entries[at].offset != 0; at = (at + 1) & mask)
    if (entries[at].hash == hash && isAt(node, written, std::uint64_t{entries[at].offset} << log2Unit_))
      return entries[at].offset;
  return std::nullopt;
}

void NodeMap::fetchNode(std::uint32_t hash, std::span<const std::uint32_t> written) const {
  if (used_ == 0)
    return;
  const Entry entry = entries_.data()[home(hash)];
  const std::uint64_t offset = std::uint64_t{entry.offset} << log2Unit_;
  if (entry.hash == hash && offset < written.size())
    __builtin_prefetch(written.data() + offset);
}

Expected<void> NodeMap::insert(std::uint32_t hash, std::uint32_t offset) {
  if (log2Size_ == 0 || 4 * (used_ + 1) > std::uint64_t{3} << log2Size_)
    VOXC_TRY(grow());
  place({offset, hash});
  return {};
}

void NodeMap::clear() {
  if (used_ == 0)
    return;
  std::fill_n(entries_.data(), std::uint64_t{1} << log2Size_, Entry{});
  // A table much larger than what was in it is used in part from now on, so that clearing costs what there
  // was.
  while (log2Size_ > kLog2Smallest && std::uint64_t{1} << log2Size_ > 8 * used_)
    --log2Size_;
  used_ = 0;
}

Expected<void> NodeMap::grow() {
  ScratchArray<Entry> larger(memory_);
  const int log2Size = std::max(log2Size_ + 1, kLog2Smallest);
  VOXC_TRY(larger.resize(std::uint64_t{1} << log2Size));
  const std::uint64_t size = used_ == 0 ? 0 : std::uint64_t{1} << log2Size_;
  std::swap(entries_, larger);
  log2Size_ = log2Size;
  used_ = 0;
  for (std::uint64_t i = 0; i < size; ++i) {
    if (larger[i].offset != 0)
      place(larger[i]);
    if (i % kEntriesBetweenRelief == 0)
      memory_->relieve();
  }
  return {};
}

void NodeMap::place(Entry entry) {
  const std::uint64_t mask = (std::uint64_t{1} << log2Size_) - 1;
  std::uint64_t at = home(entry.hash);
  while (entries_[at].offset != 0)
    at = (at + 1) & mask;
  entries_[at] = entry;
  ++used_;
}

} // namespace voxc
