// Counting different values in bounded memory.
#pragma once

#include "voxc/Facts/Facts.h"

#include "Support/HashTable.h"

#include <cstddef>
#include <cstdint>

namespace voxc {

/// A set of values that forgets, when it has too many, all whose hash ends in a one, then those in 10, and so
/// on: what is left is a random sample of known share (adaptive sampling, see `DistinctCount`).
class DistinctSet {
public:
  /// Keeps `most` values at most (1 or more).
  explicit DistinctSet(std::size_t most) : most_(most) {}

  /// Adds a value that is not 0.
  void insert(std::uint64_t value);
  DistinctCount count() const { return {std::uint64_t{hashes_.size()} << level_, level_ == 0}; }

private:
  struct Nothing {};

  bool isSampled(std::uint64_t hash) const { return (hash & ((std::uint64_t{1} << level_) - 1)) == 0; }

  std::size_t most_;
  HashTable<Nothing> hashes_;
  int level_ = 0; ///< Zeros that the hash of a kept value ends in.
};

} // namespace voxc
