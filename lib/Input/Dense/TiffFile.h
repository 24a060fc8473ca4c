// A TIFF file in memory, and how the samples of its pages are stored. Through libtiff.
#pragma once

#include "Input/Dense/Samples.h"

#include <tiffio.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace voxc {

/// A file in memory as libtiff reads it, and the first thing that went wrong.
struct TiffMemory {
  std::span<const std::byte> bytes;
  std::uint64_t at = 0;
  std::string problem;
};

/// Null if it is no TIFF file; `memory` outlives it, and says why.
TIFF *openTiff(TiffMemory &memory);

/// How the samples of a page are stored.
struct TiffPage {
  std::uint32_t width = 0, height = 0;
  std::uint16_t bits = 1, samples = 1, format = SAMPLEFORMAT_UINT;
  std::uint16_t photometric = PHOTOMETRIC_MINISBLACK, planar = PLANARCONFIG_CONTIG;
  std::uint16_t extra = 0;      ///< Samples that are no colours,
  bool hasAlpha = false;        ///< the first of which is alpha.
  bool isPremultiplied = false; ///< Colours are multiplied by it.
  bool isTiled = false;
};

/// A number of the page at hand; `otherwise` where it has none.
template <typename Value> Value tiffTag(TIFF *tiff, std::uint32_t tag, Value otherwise) {
  Value value{};
  return TIFFGetFieldDefaulted(tiff, tag, &value) == 1 ? value : otherwise;
}

/// The page at hand.
TiffPage tiffPage(TIFF *tiff);

/// Whether a page has one sample a cell that is no colour.
bool isGrey(const TiffPage &page);

/// Whether its colours are samples side by side, of bytes or pairs of bytes; others are left to libtiff.
bool isPlainColour(const TiffPage &page);

/// The type of its samples; those of fewer than 8 bits are spread to bytes. Nothing: they are not read.
std::optional<SampleType> sampleTypeOf(const TiffPage &page);

} // namespace voxc
