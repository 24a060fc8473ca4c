// One slice of a volume as a PNG picture: grey samples, or the words of cells.
#pragma once

#include "voxc/Support/Error.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace voxc {

/// What a picture says of itself before it is decoded.
struct PngSlice {
  std::int32_t width = 0;
  std::int32_t height = 0;
  bool isGrey = false; ///< A byte a cell, a sample; else RGBA8, of which the word 0 is empty.

  bool operator==(const PngSlice &) const = default;
  std::uint64_t bytes() const {
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) * (isGrey ? 1 : 4);
  }
};

/// Errors: no PNG, more than 8 bits a channel, or larger than a slice may be: 2^26 cells, and no more than
/// so few bytes can hold.
Expected<PngSlice> readPngSlice(std::span<const std::byte> bytes);

/// Writes the cells, the upper row first, to `target`, which has `slice.bytes()` of them. Of a picture
/// without alpha black is empty. Errors: broken, or not what `slice` says.
Expected<void> decodePngSlice(std::span<const std::byte> bytes, const PngSlice &slice,
                              std::span<std::byte> target);

} // namespace voxc
