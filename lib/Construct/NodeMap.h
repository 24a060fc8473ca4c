// Finding a node that was written before: a flat hash table over the words of the volume itself.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace voxc {

/// Maps the contents of nodes to their offsets. Entries hold no copy of a node, only where it lies; a leaf (1
/// word) and an inner node (2 to 9) differ in length, which is part of the key.
class NodeMap {
public:
  /// The offset of a node with these contents, if one is known. `written` are the volume's words so far.
  std::optional<std::uint32_t> find(std::span<const std::uint32_t> node,
                                    const std::vector<std::uint32_t> &written) const;

  /// Adds a node that `find` did not find, which lies at `offset`.
  void insert(std::span<const std::uint32_t> node, std::uint32_t offset);

  /// Forgets all nodes; keeps the memory.
  void clear();

private:
  struct Entry {
    std::uint32_t offset;
    std::uint16_t tag;   ///< Bits of the hash, compared before the words.
    std::uint8_t length; ///< In words; 0 marks a free entry.
    std::uint8_t reserved;
  };

  void grow();
  void place(std::uint64_t hash, const Entry &entry);

  std::vector<Entry> entries_;
  std::vector<std::uint64_t> hashes_; ///< Of the entries, so that growing need not read the volume.
  std::vector<std::uint32_t> used_;   ///< Places in use, so that clearing costs what was inserted.
};

} // namespace voxc
