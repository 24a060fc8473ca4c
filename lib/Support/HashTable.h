// The hash table of the library: what is looked up for every node, brick or colour.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace voxc {

/// Open addressing over integers that are not 0: a question costs one place in memory, where
/// std::unordered_map costs three. So many low bits of a key are no part of its hash, but of the place that
/// follows from it: keys that differ in them alone lie next to each other, for those that are looked for at
/// one time.
template <typename Value, typename Key = std::uint64_t, int kLog2Near = 0> class HashTable {
public:
  HashTable() { clear(); }

  std::size_t size() const { return size_; }

  /// Forgets all; what comes next may be about as much, and has room for it.
  void clear() { reset(std::max(kLog2Least, static_cast<int>(std::bit_width(size_)))); }

  /// Null if the key is not there. Valid until the next key is added.
  const Value *find(Key key) const {
    const Entry &entry = entries_[slotOf(key)];
    return entry.key == key ? &entry.value : nullptr;
  }

  /// The value of a key, which is added if it is not there. Valid until the next key is added.
  Value &operator[](Key key) {
    Entry *entry = &entries_[slotOf(key)];
    if (entry->key == 0) {
      if (3 * (size_ + 1) > 2 * entries_.size()) {
        rebuild(log2Size() + 1, [](Key) { return true; });
        entry = &entries_[slotOf(key)];
      }
      entry->key = key;
      ++size_;
    }
    return entry->value;
  }

  /// Forgets the keys that are not kept.
  template <typename Keeps> void keepIf(const Keeps &keeps) { rebuild(log2Size(), keeps); }

  /// Brings near where the search for a key begins.
  void fetch(Key key) const { __builtin_prefetch(&entries_[home(key)]); }

  template <typename Visit> void forEach(const Visit &visit) const {
    for (const Entry &entry : entries_)
      if (entry.key != 0)
        visit(entry.key, entry.value);
  }

private:
  struct Entry {
    Key key = 0; ///< 0: free.
    [[no_unique_address]] Value value{};
  };

  static constexpr int kLog2Least = 6;
  static constexpr int kBits = 64;

  int log2Size() const { return kBits - shift_; }

  std::size_t home(Key key) const {
    constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;
    constexpr std::uint64_t kNear = (std::uint64_t{1} << kLog2Near) - 1;
    return (((key >> kLog2Near) * kGolden >> shift_) + (key & kNear)) & (entries_.size() - 1);
  }

  /// Of the key, or the free one where it would go.
  std::size_t slotOf(Key key) const {
    std::size_t slot = home(key);
    while (entries_[slot].key != key && entries_[slot].key != 0)
      slot = (slot + 1) & (entries_.size() - 1);
    return slot;
  }

  void reset(int log2Size) {
    entries_ = std::vector<Entry>(std::size_t{1} << log2Size);
    shift_ = kBits - log2Size;
    size_ = 0;
  }

  template <typename Keeps> void rebuild(int log2Size, const Keeps &keeps) {
    std::vector<Entry> before = std::exchange(entries_, {});
    reset(log2Size);
    for (Entry &entry : before)
      if (entry.key != 0 && keeps(entry.key)) {
        entries_[slotOf(entry.key)] = std::move(entry);
        ++size_;
      }
  }

  std::vector<Entry> entries_; ///< A power of two of them, at most two thirds in use.
  int shift_ = 0;
  std::size_t size_ = 0;
};

} // namespace voxc
