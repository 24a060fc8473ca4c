// Which of many rays are looked at, where not all can be.
#pragma once

#include <cstddef>
#include <cstdint>

namespace voxc {

/// Which of `all` rays a sample of `count` of them has as its i-th, i < count <= all: one of each of `count`
/// runs of equal length, at a pseudo-random place that is always the same (stratified sampling; the place is
/// by the finalizer of MurmurHash3). A fixed step would see one column of a picture, or a few, wherever it
/// has a factor in common with the picture's width.
inline std::size_t sampleIndex(std::size_t i, std::size_t count, std::size_t all) {
  std::uint64_t x = std::uint64_t{i} + 1;
  x = (x ^ x >> 33) * 0xff51afd7ed558ccdu;
  x = (x ^ x >> 33) * 0xc4ceb9fe1a85ec53u;
  x ^= x >> 33;
  const std::size_t first = i * all / count, end = (i + 1) * all / count;
  return first + x % (end - first);
}

} // namespace voxc
