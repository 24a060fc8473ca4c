// A run of a volume's words.
#pragma once

#include <cstdint>

namespace voxc {

/// Words [first, end).
struct WordRange {
  std::uint64_t first = 0;
  std::uint64_t end = 0;

  bool operator==(const WordRange &) const = default;
};

} // namespace voxc
