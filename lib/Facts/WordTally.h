// How often each word occurs, in bounded memory, and the entropy of that.
#pragma once

#include "Support/HashTable.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace voxc {

/// Counts words one by one, until there are too many different ones; then it counts groups of words instead.
class WordTally {
public:
  /// Keeps `most` different words at most (1 or more).
  explicit WordTally(std::size_t most) : most_(most) {}

  /// Counts a word, which is not 0, so many times more. False if it has been counted before; true may be said
  /// of any word once `exact` is false.
  bool add(std::uint32_t word, std::uint64_t times);

  /// False: these are counts of groups of words.
  bool exact() const { return groups_.empty(); }
  /// Zeroth-order entropy in bits; that of groups is a lower bound of that of words.
  double entropy() const;

private:
  void joinToGroups();
  std::uint64_t &groupOf(std::uint32_t word);

  std::size_t most_;
  HashTable<std::uint64_t, std::uint32_t> counts_;
  std::vector<std::uint64_t> groups_; ///< Counts by the hash of words; empty while words are counted.
};

} // namespace voxc
