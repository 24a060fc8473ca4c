// Slices through libpng, whose errors leave by longjmp: functions that they leave have nothing to destroy.
#include "Input/Dense/Slice.h"

#include "Support/Text.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

namespace voxc {

namespace {

/// What is left of the file, and what went wrong.
struct Source {
  std::span<const std::byte> bytes;
  std::array<char, 128> problem{};
};

void readBytes(png_structp png, png_bytep target, std::size_t count) {
  auto &source = *static_cast<Source *>(png_get_io_ptr(png));
  if (count > source.bytes.size())
    png_error(png, "it is cut short");
  std::memcpy(target, source.bytes.data(), count);
  source.bytes = source.bytes.subspan(count);
}

[[noreturn]] void fail(png_structp png, png_const_charp message) {
  auto &source = *static_cast<Source *>(png_get_error_ptr(png));
  std::strncpy(source.problem.data(), message, source.problem.size() - 1);
  png_longjmp(png, 1);
}

void ignore(png_structp, png_const_charp) {}

/// The header of a picture: false if it is broken.
bool readInfo(png_structp png, png_infop info) {
  if (setjmp(png_jmpbuf(png)))
    return false;
  png_read_info(png, info);
  return true;
}

/// What is done with pixels while they are read.
void setTransforms(png_structp png, png_infop info, const Slice &slice) {
  const int kind = png_get_color_type(png, info);
  const bool isWide = png_get_bit_depth(png, info) == 16;
  png_set_expand(png);
  if (slice.isGrey) {
    if (isWide && std::endian::native == std::endian::little)
      png_set_swap(png);
    return;
  }
  if (isWide)
    png_set_scale_16(png);
  if ((kind & PNG_COLOR_MASK_COLOR) == 0)
    png_set_gray_to_rgb(png);
  png_set_filler(png, 255, PNG_FILLER_AFTER);
}

/// Rows of pixels: false if they are broken.
bool readRows(png_structp png, png_infop info, const Slice &slice, std::byte *target) {
  if (setjmp(png_jmpbuf(png)))
    return false;
  setTransforms(png, info, slice);
  const int passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  const std::size_t row = slice.bytes() / static_cast<std::size_t>(slice.height);
  if (png_get_rowbytes(png, info) != row)
    return false;
  for (int pass = 0; pass < passes; ++pass)
    for (std::int32_t y = 0; y < slice.height; ++y)
      png_read_row(png, reinterpret_cast<png_bytep>(target) + static_cast<std::size_t>(y) * row, nullptr);
  png_read_end(png, nullptr);
  return true;
}

/// What libpng does not tell.
struct PngEnd {
  bool hasFrames = false;
  std::uint64_t behind = 0; ///< Bytes behind the last chunk.
};

PngEnd findEnd(std::span<const std::byte> bytes) {
  constexpr std::size_t kSignature = 8, kAround = 12; // Length, type and checksum of a chunk.
  PngEnd end;
  std::span<const std::byte> rest = bytes.subspan(std::min(kSignature, bytes.size()));
  while (rest.size() >= kAround) {
    std::array<std::uint8_t, 8> head;
    std::memcpy(head.data(), rest.data(), head.size());
    const std::uint32_t length =
        std::uint32_t{head[0]} << 24 | head[1] << 16u | head[2] << 8u | std::uint32_t{head[3]};
    const std::string_view type(reinterpret_cast<const char *>(rest.data()) + 4, 4);
    if (length > rest.size() - kAround)
      break;
    rest = rest.subspan(kAround + length);
    end.hasFrames |= type == "acTL";
    if (type == "IEND") {
      end.behind = rest.size();
      break;
    }
  }
  return end;
}

class PngSlice final : public SliceReader {
public:
  explicit PngSlice(std::span<const std::byte> bytes) : all_(bytes), source_{bytes}, size_(bytes.size()) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source_, fail, ignore);
    info_ = png_ ? png_create_info_struct(png_) : nullptr;
  }
  ~PngSlice() override {
    if (png_)
      png_destroy_read_struct(&png_, info_ ? &info_ : nullptr, nullptr);
  }
  PngSlice(const PngSlice &) = delete;
  PngSlice &operator=(const PngSlice &) = delete;

  Expected<void> open() {
    if (!info_)
      return Error::environment("out of memory for a PNG picture");
    if (source_.bytes.size() < 8 ||
        png_sig_cmp(reinterpret_cast<png_const_bytep>(source_.bytes.data()), 0, 8))
      return Error::input("it is no PNG picture, or a broken one: it does not begin as one");
    png_set_read_fn(png_, &source_, readBytes);
    png_set_crc_action(png_, PNG_CRC_ERROR_QUIT, PNG_CRC_WARN_DISCARD);
    if (!readInfo(png_, info_))
      return Error::input(std::string("it is no PNG picture, or a broken one: ") + source_.problem.data());
    const std::uint64_t width = png_get_image_width(png_, info_);
    const std::uint64_t height = png_get_image_height(png_, info_);
    if (auto checked = checkSlice(width, height, size_); !checked)
      return checked;
    const int kind = png_get_color_type(png_, info_);
    const bool hasClear = png_get_valid(png_, info_, PNG_INFO_tRNS) != 0;
    hasAlpha_ = (kind & PNG_COLOR_MASK_ALPHA) != 0 || hasClear;
    slice_ = {static_cast<std::int32_t>(width), static_cast<std::int32_t>(height),
              (kind & PNG_COLOR_MASK_COLOR) == 0 && !hasAlpha_,
              png_get_bit_depth(png_, info_) == 16 ? SampleType::Uint16 : SampleType::Uint8};
    if (!slice_.isGrey)
      slice_.type = SampleType::Uint8;
    tellLeftOut();
    return {};
  }

  Expected<bool> next(Slice &slice) override {
    slice = slice_;
    return !std::exchange(isRead_, true);
  }

  Expected<void> decode(std::span<std::byte> target) override {
    if (!readRows(png_, info_, slice_, target.data()))
      return Error::input(std::string("it is broken: ") + source_.problem.data());
    if (!slice_.isGrey && !hasAlpha_)
      clearBlack(target);
    return {};
  }

private:
  void tellLeftOut() {
    png_uint_32 x = 0, y = 0;
    int unit = 0;
    if (png_get_pHYs(png_, info_, &x, &y, &unit) != 0)
      if (auto sentence = saysOblong({static_cast<double>(x), static_cast<double>(y)}))
        warnings.push_back(std::move(*sentence));
    const PngEnd end = findEnd(all_);
    if (end.hasFrames)
      warnings.emplace_back("it is an animation, of which the first picture is taken");
    if (end.behind != 0)
      warnings.push_back(countedAre(end.behind, "byte") + " left out, which lie behind the picture");
  }

  std::span<const std::byte> all_;

  Source source_;
  std::uint64_t size_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  Slice slice_;
  bool hasAlpha_ = false;
  bool isRead_ = false;
};

} // namespace

Expected<void> checkSlice(std::uint64_t width, std::uint64_t height, std::uint64_t bytes) {
  constexpr std::uint64_t kMostCells = std::uint64_t{1} << 26;
  // No PNG has more texels a byte: deflate makes 1032 bytes of one, of one bit a texel.
  constexpr std::uint64_t kMostCellsAByte = 8400;
  constexpr std::uint64_t kFewCells = 1 << 16;
  const bool isPossible = width > 0 && height > 0 && width <= kMostCells && height <= kMostCells;
  if (isPossible && width * height <= kMostCells && width * height <= kFewCells + kMostCellsAByte * bytes)
    return {};
  return Error::input("it has " + std::to_string(width) + "x" + std::to_string(height) +
                      " cells, more than the 2^26 that a slice may have, or than its " +
                      std::to_string(bytes) + " bytes can hold");
}

std::optional<std::string> saysOblong(const std::array<double, 2> &pixelsAUnit) {
  const auto [x, y] = pixelsAUnit;
  constexpr double kSame = 1e-3;
  if (!(x > 0 && y > 0) || std::abs(x / y - 1) <= kSame)
    return std::nullopt;
  std::array<char, 64> sides;
  std::snprintf(sides.data(), sides.size(), "1 : %.4g", x / y);
  return "its pixels are no squares (" + std::string(sides.data()) +
         ", width to height), which is left out: voxels are cubes";
}

void clearBlack(std::span<std::byte> cells) {
  constexpr std::uint32_t kBlack = 0xff000000;
  for (std::size_t at = 0; at < cells.size(); at += 4) {
    std::uint32_t word = 0;
    std::memcpy(&word, cells.data() + at, sizeof word);
    if (word == kBlack)
      std::memset(cells.data() + at, 0, sizeof word);
  }
}

Expected<std::unique_ptr<SliceReader>> openPngSlice(std::span<const std::byte> bytes) {
  auto slice = std::make_unique<PngSlice>(bytes);
  if (auto opened = slice->open(); !opened)
    return opened.error();
  return std::unique_ptr<SliceReader>(std::move(slice));
}

} // namespace voxc
