// Decoding of compressed images: PNG, JPEG, WebP, BMP and TGA, within limits.
#pragma once

#include "voxc/Support/WorkingMemory.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

namespace voxc {

/// Texels in rows from the top, RGBA8 with R in the low byte.
struct DecodedImage {
  int width = 0;
  int height = 0;
  ScratchArray<std::uint32_t> texels;
};

/// What the numbers of an image mean.
enum class ImageNumbers : std::uint8_t {
  AsSaid, ///< What the image says of its gamma and its profile; sRGB if it says nothing.
  Stored, ///< sRGB, whatever it says.
};

/// Decodes the images of one model to RGBA8, within limits that hold for all of them together.
class ImageDecoder {
public:
  explicit ImageDecoder(std::shared_ptr<WorkingMemory> memory, ImageNumbers numbers = ImageNumbers::AsSaid)
      : memory_(std::move(memory)), numbers_(numbers) {}

  /// Errors: `Input` for what is no image that is known, broken or too large; others as of `ScratchArray`.
  Expected<DecodedImage> decode(std::span<const std::byte> bytes);

  /// What a library may have held at once beside the texels.
  std::uint64_t libraryPeakBytes() const { return libraryPeak_; }

private:
  std::shared_ptr<WorkingMemory> memory_;
  ImageNumbers numbers_;
  std::int64_t texelsLeft_ = std::int64_t{1} << 30;
  std::uint64_t libraryPeak_ = 0;
};

} // namespace voxc
