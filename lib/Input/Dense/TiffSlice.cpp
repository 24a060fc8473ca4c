// Slices through libtiff: the pages of a file in memory.
#include "Input/Dense/Slice.h"
#include "Input/Dense/TiffFile.h"
#include "Support/Text.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <utility>

namespace voxc {

namespace {

/// Calls `take(x, y, samples, count)` for runs of one row: `plane` of a page whose channels lie apart, else
/// all channels. False if the file is broken.
template <typename Take> bool readPlane(TIFF *tiff, const TiffPage &page, std::uint16_t plane, Take take) {
  if (!page.isTiled) {
    std::vector<std::byte> row(static_cast<std::size_t>(TIFFScanlineSize(tiff)));
    for (std::uint32_t y = 0; y < page.height; ++y) {
      if (TIFFReadScanline(tiff, row.data(), y, plane) != 1)
        return false;
      take(0u, y, row.data(), page.width);
    }
    return true;
  }
  const auto width = tiffTag<std::uint32_t>(tiff, TIFFTAG_TILEWIDTH, 0);
  const auto height = tiffTag<std::uint32_t>(tiff, TIFFTAG_TILELENGTH, 0);
  const tmsize_t bytes = TIFFTileSize(tiff);
  if (width == 0 || height == 0 || bytes <= 0 || bytes > tmsize_t{1} << 29)
    return false;
  std::vector<std::byte> tile(static_cast<std::size_t>(bytes));
  for (std::uint32_t y = 0; y < page.height; y += height)
    for (std::uint32_t x = 0; x < page.width; x += width) {
      if (TIFFReadTile(tiff, tile.data(), x, y, 0, plane) < 0)
        return false;
      for (std::uint32_t row = 0; row < std::min(height, page.height - y); ++row)
        take(x, y + row, tile.data() + TIFFTileRowSize(tiff) * static_cast<tmsize_t>(row),
             std::min(width, page.width - x));
    }
  return true;
}

/// Sample `i` of a row of 1, 2 or 4 bits each.
std::byte bitsAt(const std::byte *row, std::uint32_t i, unsigned bits) {
  const unsigned shift = 8 - bits - i * bits % 8;
  return row[std::size_t{i} * bits / 8] >> shift & std::byte((1u << bits) - 1);
}

/// Colours that were multiplied by their alpha, as they were before.
void divideByAlpha(std::span<std::byte> cells) {
  for (std::size_t at = 0; at < cells.size(); at += 4) {
    const auto alpha = std::to_integer<unsigned>(cells[at + 3]);
    if (alpha == 0 || alpha == 255)
      continue;
    for (std::byte &level : cells.subspan(at, 3)) {
      const unsigned whole = (std::to_integer<unsigned>(level) * 255 + alpha / 2) / alpha;
      level = static_cast<std::byte>(std::min(255u, whole));
    }
  }
}

class TiffSlices final : public SliceReader {
public:
  explicit TiffSlices(std::span<const std::byte> bytes) : memory_{bytes, 0, {}}, tiff_(openTiff(memory_)) {}
  ~TiffSlices() override {
    if (tiff_)
      TIFFClose(tiff_);
  }
  TiffSlices(const TiffSlices &) = delete;
  TiffSlices &operator=(const TiffSlices &) = delete;

  bool isOpen() const { return tiff_ != nullptr; }
  Error broken() const {
    return Error::input("it is no TIFF file that can be read" +
                        (memory_.problem.empty() ? std::string() : ": " + memory_.problem));
  }

  Expected<bool> next(Slice &slice) override {
    constexpr std::uint32_t kNoSlice = FILETYPE_REDUCEDIMAGE | FILETYPE_MASK;
    do {
      if (std::exchange(isFirst_, false)) {
        tellDescription();
      } else if (TIFFReadDirectory(tiff_) != 1) {
        tellLeftOut();
        return memory_.problem.empty() ? Expected<bool>(false) : broken();
      }
      page_ = tiffPage(tiff_);
    } while ((tiffTag<std::uint32_t>(tiff_, TIFFTAG_SUBFILETYPE, 0) & kNoSlice) != 0 && ++leftOut_ > 0);
    ++pages_;
    VOXC_TRY(checkPage());
    tellPage();
    slice = slice_;
    return true;
  }

  Expected<void> decode(std::span<std::byte> target) override {
    const bool isDone = slice_.isGrey          ? decodeGrey(target)
                        : isPlainColour(page_) ? decodeColours(target)
                                               : decodeByLibrary(target);
    if (!isDone || !memory_.problem.empty())
      return Error::input("it is broken: " + memory_.problem);
    if (!slice_.isGrey && !page_.hasAlpha)
      clearBlack(target);
    // libtiff multiplies all colours that it decodes itself.
    if (!slice_.isGrey && page_.hasAlpha && (page_.isPremultiplied || !isPlainColour(page_)))
      divideByAlpha(target);
    return {};
  }

private:
  Expected<void> checkPage() {
    VOXC_TRY(checkSlice(page_.width, page_.height, memory_.bytes.size()));
    // Many pages may share the bytes of one.
    cells_ += std::uint64_t{page_.width} * page_.height;
    constexpr std::uint64_t kMostCellsAByte = 8400;
    if (cells_ > (std::uint64_t{1} << 16) + kMostCellsAByte * memory_.bytes.size())
      return Error::input("its pages have more cells than its " + std::to_string(memory_.bytes.size()) +
                          " bytes can hold");
    slice_ = {static_cast<std::int32_t>(page_.width), static_cast<std::int32_t>(page_.height), isGrey(page_),
              SampleType::Uint8};
    if (slice_.isGrey) {
      const auto type = sampleTypeOf(page_);
      if (!type)
        return Error::input(
            "it has samples of " + std::to_string(page_.bits) + " bits of the kind " +
            std::to_string(page_.format) +
            ", which are not read; whole numbers of 1 to 64 bits are, and floats of 32 and 64");
      slice_.type = *type;
      slice_.bits = std::min<unsigned>(page_.bits, 8);
    }
    return {};
  }

  bool decodeGrey(std::span<std::byte> target) {
    const std::size_t bytes = byteSize(slice_.type);
    const bool isInverted = page_.photometric == PHOTOMETRIC_MINISWHITE && isWhole(slice_.type);
    const std::size_t stride = page_.planar == PLANARCONFIG_CONTIG ? page_.samples : 1;
    return readPlane(tiff_, page_, 0,
                     [&](std::uint32_t x, std::uint32_t y, const std::byte *row, std::uint32_t n) {
                       std::byte *cell = target.data() + (std::size_t{y} * page_.width + x) * bytes;
                       for (std::uint32_t i = 0; i < n; ++i, cell += bytes) {
                         if (page_.bits < 8)
                           *cell = bitsAt(row, i * static_cast<std::uint32_t>(stride), page_.bits);
                         else
                           std::memcpy(cell, row + i * stride * bytes, bytes);
                         for (std::size_t byte = 0; isInverted && byte < bytes; ++byte)
                           cell[byte] ^= page_.bits < 8 ? std::byte((1u << page_.bits) - 1) : std::byte{255};
                       }
                     });
  }

  /// 0 to 255 of a sample.
  std::byte byteAt(const std::byte *sample, bool isAlpha) {
    if (page_.bits == 8)
      return *sample;
    std::uint16_t value = 0;
    std::memcpy(&value, sample, sizeof value);
    if (!isAlpha)
      largestColour = std::max<std::uint32_t>(largestColour, value);
    return static_cast<std::byte>((value * 255u + 32767u) / 65535u);
  }

  bool decodeColours(std::span<std::byte> target) {
    const std::size_t bytes = page_.bits / 8u;
    const std::size_t colours = page_.samples - std::size_t{page_.extra};
    std::fill(target.begin(), target.end(), std::byte{255});
    const bool areApart = page_.planar == PLANARCONFIG_SEPARATE;
    const std::size_t channels = colours + (page_.hasAlpha ? 1 : 0);
    for (std::size_t plane = 0; plane < (areApart ? channels : 1); ++plane) {
      const bool isRead =
          readPlane(tiff_, page_, static_cast<std::uint16_t>(plane),
                    [&](std::uint32_t x, std::uint32_t y, const std::byte *row, std::uint32_t n) {
                      std::byte *cell = target.data() + (std::size_t{y} * page_.width + x) * 4;
                      for (std::uint32_t i = 0; i < n; ++i, cell += 4)
                        for (std::size_t channel = areApart ? plane : 0;
                             channel < (areApart ? plane + 1 : channels); ++channel)
                          put(cell, channel, colours,
                              byteAt(row + (areApart ? i : i * std::size_t{page_.samples} + channel) * bytes,
                                     channel >= colours));
                    });
      if (!isRead)
        return false;
    }
    return true;
  }

  /// Writes a channel; that of a grey picture is red, green and blue, and what follows colours is alpha.
  static void put(std::byte *cell, std::size_t channel, std::size_t colours, std::byte value) {
    if (channel >= colours)
      cell[3] = value;
    else if (colours == 1)
      cell[0] = cell[1] = cell[2] = value;
    else
      cell[channel] = value;
  }

  /// Palettes, YCbCr and the like: words with R in the low byte, which is as libtiff has them.
  bool decodeByLibrary(std::span<std::byte> target) {
    std::array<char, 1024> problem{};
    if (TIFFRGBAImageOK(tiff_, problem.data()) != 1) {
      memory_.problem = problem.data();
      return false;
    }
    std::vector<std::uint32_t> words(std::size_t{page_.width} * page_.height);
    if (TIFFReadRGBAImageOriented(tiff_, page_.width, page_.height, words.data(), ORIENTATION_TOPLEFT, 1) !=
        1)
      return false;
    std::memcpy(target.data(), words.data(), target.size());
    return true;
  }

  /// What programs of microscopes say in words about pages that are not all slices.
  void tellDescription() {
    const std::array<double, 2> pixelsAUnit{tiffTag<float>(tiff_, TIFFTAG_XRESOLUTION, 0),
                                            tiffTag<float>(tiff_, TIFFTAG_YRESOLUTION, 0)};
    const char *text = nullptr;
    const bool isDescribed = TIFFGetField(tiff_, TIFFTAG_IMAGEDESCRIPTION, &text) == 1 && text;
    const std::string_view description =
        isDescribed ? std::string_view(text).substr(0, 1 << 16) : std::string_view();
    images_ = imageJImages(description);
    const auto has = [&](std::string_view word) { return description.find(word) != std::string_view::npos; };
    if (has("<OME") || (description.starts_with("ImageJ") && (has("channels=") || has("frames="))))
      warnings.emplace_back("it may have channels or times beside slices; every page is taken as a slice");
    spacing = imageJSpacing(description, pixelsAUnit);
    if (!spacing)
      if (auto sentence = saysOblong(pixelsAUnit))
        warnings.push_back(std::move(*sentence));
  }

  /// What a page has that is not taken, of each kind once.
  void tellPage() {
    const bool hasMore =
        slice_.isGrey ? page_.samples > 1 : isPlainColour(page_) && page_.extra > (page_.hasAlpha ? 1 : 0);
    if (hasMore && !std::exchange(toldSamples_, true))
      warnings.push_back("its pixels have " + std::to_string(page_.samples) + " samples; those behind the " +
                         (slice_.isGrey ? "first" : "colour") + " are left out");
    const auto orientation = tiffTag<std::uint16_t>(tiff_, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
    if (orientation != ORIENTATION_TOPLEFT && !std::exchange(toldOrientation_, true))
      warnings.push_back("its pages begin at another corner than the upper left (orientation " +
                         std::to_string(orientation) + "), which is left out: rows lie as they are stored");
  }

  void tellLeftOut() {
    if (images_ > pages_)
      warnings.push_back("its description names " + std::to_string(images_) + " images, but it has " +
                         counted(pages_, "page") + "; the others are left out");
    if (leftOut_ > 0)
      warnings.push_back(countedAre(leftOut_, "page") + " left out, as masks or smaller copies of others");
  }

  TiffMemory memory_;
  TIFF *tiff_;
  TiffPage page_;
  Slice slice_;
  bool isFirst_ = true;
  std::uint64_t cells_ = 0;
  std::uint64_t leftOut_ = 0;
  std::uint64_t pages_ = 0;
  std::uint64_t images_ = 0; ///< By ImageJ's description.
  bool toldSamples_ = false;
  bool toldOrientation_ = false;
};

} // namespace

bool isTiff(std::span<const std::byte> bytes) {
  if (bytes.size() < 4)
    return false;
  const std::string_view magic(reinterpret_cast<const char *>(bytes.data()), 4);
  return magic == std::string_view("II*\0", 4) || magic == std::string_view("MM\0*", 4) ||
         magic == std::string_view("II+\0", 4) || magic == std::string_view("MM\0+", 4);
}

Expected<std::unique_ptr<SliceReader>> openTiffSlices(std::span<const std::byte> bytes) {
  auto slices = std::make_unique<TiffSlices>(bytes);
  if (!slices->isOpen())
    return slices->broken();
  return std::unique_ptr<SliceReader>(std::move(slices));
}

} // namespace voxc
