// Pictures that are slices of a volume: grey samples, or the words of cells.
#pragma once

#include "Input/Dense/ImageJ.h"
#include "Input/Dense/Samples.h"
#include "voxc/Support/Error.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace voxc {

/// What a picture says of itself before it is decoded.
struct Slice {
  std::int32_t width = 0;
  std::int32_t height = 0;
  bool isGrey = false;                 ///< A sample a cell; else RGBA8, of which the word 0 is empty.
  SampleType type = SampleType::Uint8; ///< Of grey samples, in this machine's byte order.
  unsigned bits = 8; ///< Of grey samples in a byte: 1, 2, 4 or 8. They stay the numbers that they are.

  /// Whether both lie in one stack, perhaps with samples of other numbers of bits in a byte.
  bool isLike(const Slice &other) const {
    return width == other.width && height == other.height && isGrey == other.isGrey && type == other.type;
  }
  std::uint64_t bytes() const {
    const std::uint64_t cells = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    return cells * (isGrey ? byteSize(type) : 4);
  }
};

/// Error: larger than a slice may be: 2^26 cells, and no more than `bytes` of a compressed picture can hold.
Expected<void> checkSlice(std::uint64_t width, std::uint64_t height, std::uint64_t bytes);

/// A sentence about pixels that are no squares by what a picture says, so many a unit of length; nothing if
/// they are, or if it says nothing (0).
std::optional<std::string> saysOblong(const std::array<double, 2> &pixelsAUnit);

/// Of words without alpha, black is empty: the word 0.
void clearBlack(std::span<std::byte> cells);

/// The pictures of one file, one after the other.
class SliceReader {
public:
  virtual ~SliceReader() = default;

  /// Goes on to the next picture, at first to the first one; false behind the last. Errors: broken, larger
  /// than a slice may be, or of a kind that is not read.
  virtual Expected<bool> next(Slice &slice) = 0;

  /// Writes the cells of the picture, the upper row first, to `target`, which has `bytes()` of them. Of
  /// pictures without alpha black is empty. Error: broken.
  virtual Expected<void> decode(std::span<std::byte> target) = 0;

  /// What of the file is left out, or means something else; one sentence each. Once all pictures are read.
  std::vector<std::string> warnings;

  /// The largest number of colours of 16 bits, of pictures that were decoded; 0: there are none.
  std::uint32_t largestColour = 0;

  /// How far apart samples are, where the file says so. Known with the first picture.
  std::optional<StackSpacing> spacing;
};

/// Readers of a PNG picture, of 8 or 16 bits a channel, and of the pages of a TIFF file, of 1 to 64 bits.
/// `bytes` must outlive them. Errors: broken, or larger than a slice may be.
Expected<std::unique_ptr<SliceReader>> openPngSlice(std::span<const std::byte> bytes);
Expected<std::unique_ptr<SliceReader>> openTiffSlices(std::span<const std::byte> bytes);

/// Whether bytes begin as those of a TIFF file.
bool isTiff(std::span<const std::byte> bytes);

} // namespace voxc
