// The checksum of voxc's files: XXH3, 64 bits, made piece by piece.
#pragma once

#include <cstddef>
#include <cstdint>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace voxc {

class Checksum {
public:
  Checksum() { XXH3_64bits_reset(&state_); }
  void add(const void *data, std::size_t size) { XXH3_64bits_update(&state_, data, size); }
  std::uint64_t digest() const { return XXH3_64bits_digest(&state_); }

private:
  XXH3_state_t state_;
};

} // namespace voxc
