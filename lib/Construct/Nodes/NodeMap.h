// Finding words that were written before: a flat hash table over the words of the volume itself.
#pragma once

#include "voxc/Support/WorkingMemory.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace voxc {

/// Maps the contents of nodes to their offsets. An entry is eight bytes, half of them bits of the hash; it
/// holds no copy of a node, only where it lies. No node of a map may be the beginning of another one: nodes
/// whose first word tells their length satisfy that, and so do nodes of one length.
class NodeMap {
public:
  /// Offsets count 2^log2Unit words.
  explicit NodeMap(const std::shared_ptr<WorkingMemory> &memory, int log2Unit = 0)
      : memory_(memory), entries_(memory), log2Unit_(log2Unit) {}

  static std::uint32_t hashOf(std::span<const std::uint32_t> node);
  /// A hash of one word that no other word has.
  static std::uint32_t hashOf(std::uint32_t word);

  /// The offset of a node with these contents and this hash, if one is known; `written` are the volume's
  /// words.
  std::optional<std::uint32_t> find(std::uint32_t hash, std::span<const std::uint32_t> node,
                                    std::span<const std::uint32_t> written) const;

  /// The same in a map of single words, each with the hash of its own.
  std::optional<std::uint32_t> find(std::uint32_t hash) const;

  /// For those that are looked for soon: brings near where the search for this hash begins, and then, once
  /// that is there, the node that lies there.
  void fetch(std::uint32_t hash) const {
    if (used_ > 0)
      __builtin_prefetch(&entries_.data()[home(hash)]);
  }
  void fetchNode(std::uint32_t hash, std::span<const std::uint32_t> written) const;

  /// Adds a node that `find` did not find, which lies at `offset` (not 0). Error: no memory.
  Expected<void> insert(std::uint32_t hash, std::uint32_t offset);

  /// Forgets all nodes, at the cost of what there were.
  void clear();

private:
  struct Entry {
    std::uint32_t offset; ///< 0: free.
    std::uint32_t hash;
  };

  /// Where the search for a hash begins: its high bits, so that growing keeps the order of the entries.
  std::uint64_t home(std::uint32_t hash) const { return hash >> (32 - log2Size_); }
  void place(Entry entry);
  Expected<void> grow();

  static constexpr int kLog2Smallest = 6;

  std::shared_ptr<WorkingMemory> memory_;
  ScratchArray<Entry> entries_;
  int log2Unit_;
  int log2Size_ = 0; ///< 0: no table yet.
  std::uint64_t used_ = 0;
};

} // namespace voxc
