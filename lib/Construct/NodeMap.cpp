// An open-addressing hash table with linear probing, at most half full.
#include "NodeMap.h"

#include <algorithm>
#include <utility>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace voxc {
namespace {

std::uint64_t hashOf(std::span<const std::uint32_t> node) {
  return XXH3_64bits(node.data(), node.size_bytes());
}

std::uint16_t tagOf(std::uint64_t hash) { return static_cast<std::uint16_t>(hash >> 48); }

} // namespace

std::optional<std::uint32_t> NodeMap::find(std::span<const std::uint32_t> node,
                                           const std::vector<std::uint32_t> &written) const {
  if (entries_.empty())
    return std::nullopt;
  const std::uint64_t hash = hashOf(node);
  const std::size_t mask = entries_.size() - 1;
  for (std::size_t at = hash & mask; entries_[at].length != 0; at = (at + 1) & mask) {
    const Entry &entry = entries_[at];
    if (entry.tag == tagOf(hash) && entry.length == node.size() &&
        std::equal(node.begin(), node.end(), written.begin() + entry.offset))
      return entry.offset;
  }
  return std::nullopt;
}

void NodeMap::insert(std::span<const std::uint32_t> node, std::uint32_t offset) {
  if (2 * (used_.size() + 1) > entries_.size())
    grow();
  const std::uint64_t hash = hashOf(node);
  place(hash, {offset, tagOf(hash), static_cast<std::uint8_t>(node.size()), 0});
}

void NodeMap::clear() {
  for (const std::uint32_t at : used_)
    entries_[at] = {};
  used_.clear();
}

void NodeMap::place(std::uint64_t hash, const Entry &entry) {
  const std::size_t mask = entries_.size() - 1;
  std::size_t at = hash & mask;
  while (entries_[at].length != 0)
    at = (at + 1) & mask;
  entries_[at] = entry;
  hashes_[at] = hash;
  used_.push_back(static_cast<std::uint32_t>(at));
}

void NodeMap::grow() {
  const std::size_t size = std::max<std::size_t>(64, 2 * entries_.size());
  const std::vector<Entry> entries = std::exchange(entries_, std::vector<Entry>(size));
  const std::vector<std::uint64_t> hashes = std::exchange(hashes_, std::vector<std::uint64_t>(size));
  const std::vector<std::uint32_t> used = std::exchange(used_, {});
  used_.reserve(size / 2);
  for (const std::uint32_t at : used)
    place(hashes[at], entries[at]);
}

} // namespace voxc
