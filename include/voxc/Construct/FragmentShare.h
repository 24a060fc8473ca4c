// Which fragment of a volume a file is, and what it is to hold.
#pragma once

#include <cstdint>

namespace voxc {

/// One of the fragments of a volume: the cubes [begin, end), by their numbers.
struct FragmentShare {
  std::uint64_t index = 0; ///< Which fragment this is, from 0,
  std::uint64_t count = 1; ///< and of how many.
  std::uint64_t begin = 0;
  std::uint64_t end = 0;

  bool operator==(const FragmentShare &) const = default;
};

} // namespace voxc
