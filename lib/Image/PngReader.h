// PNG pictures, with what they say of themselves, as samples or as texels.
#pragma once

#include "voxc/Support/Error.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace voxc {

/// What the numbers of a picture become.
enum class PngForm : std::uint8_t {
  Samples, ///< As they are: samples of grey, of 8 or 16 bits in this machine's byte order; others RGBA8.
  Texels,  ///< RGBA8 in sRGB, by what it says of its gamma and its profile.
  Stored,  ///< RGBA8, whatever it says of them.
};

/// What a PNG says of itself before it is decoded.
struct PngHeader {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  bool hasColour = false;
  bool hasAlpha = false;
  bool isGrey = false;                 ///< It is decoded to samples: it has neither colour nor alpha.
  unsigned bits = 8;                   ///< Of a channel in the file.
  bool hasFrames = false;              ///< It is an animation, of which the first picture is decoded.
  std::array<double, 2> pixelsAUnit{}; ///< Of width and height, of some length; 0: it does not say.
  std::uint64_t bytesBehind = 0;       ///< Bytes behind the picture.

  bool isWide() const { return bits == 16; }
  std::size_t rowBytes() const { return std::size_t{width} * (!isGrey ? 4 : isWide() ? 2 : 1); }
};

class PngReader {
public:
  virtual ~PngReader() = default;

  const PngHeader &header() const { return header_; }

  /// Writes the picture, the upper row first, to `target`, which has `rowBytes()` for each. Once. Error: what
  /// is broken.
  virtual Expected<void> decode(std::span<std::byte> target) = 0;

protected:
  PngHeader header_;
};

/// Opens a PNG, of any size. `bytes` must outlive it. Errors: `Input`, no PNG or a broken one; `Environment`,
/// no memory.
Expected<std::unique_ptr<PngReader>> openPng(std::span<const std::byte> bytes, PngForm form);

} // namespace voxc
