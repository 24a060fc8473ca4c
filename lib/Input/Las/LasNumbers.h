// Little-endian numbers of LAS files.
#pragma once

#include <bit>
#include <cstddef>
#include <cstring>
#include <span>

namespace voxc {

static_assert(std::endian::native == std::endian::little);

/// The number at a place that lies within `bytes`.
template <typename Number> Number lasNumber(std::span<const std::byte> bytes, std::size_t at) {
  Number number;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

} // namespace voxc
