// The header of a NumPy array.
#pragma once

#include "Input/Dense/Samples.h"
#include "voxc/Support/Error.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace voxc {

struct NpyHeader {
  SampleLayout layout;
  bool isBool = false;
  bool isFortran = false;           ///< The first index is the fastest, else the last.
  std::vector<std::uint64_t> shape; ///< As the array has it: of three axes z, y, x.
  std::uint64_t dataOffset = 0;     ///< Of the first sample, from the magic on.
};

/// Reads a header at the front of `bytes`. Errors: no NumPy array; values that are no numbers of 8 to 64
/// bits.
Expected<NpyHeader> readNpyHeader(std::span<const std::byte> bytes);

/// Bytes that a header takes at most.
inline constexpr std::size_t kMostNpyHeader = 1 << 16;

} // namespace voxc
