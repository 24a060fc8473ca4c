// PNG by libpng, whose errors leave by longjmp: functions that they leave have nothing to destroy.
#include "Image/PngReader.h"

#include <png.h>

#include <algorithm>
#include <bit>
#include <csetjmp>
#include <cstring>
#include <string>
#include <string_view>

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

/// The header of a picture: false if it is broken. Of chunks beside the picture's own only these are read:
/// texts may be compressed, and take gigabytes.
bool readInfo(png_structp png, png_infop info) {
  constexpr png_byte kRead[] = "gAMA\0iCCP\0pHYs\0sRGB";
  if (setjmp(png_jmpbuf(png)))
    return false;
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_AS_DEFAULT, kRead, sizeof kRead / 5);
  png_read_info(png, info);
  return true;
}

/// What is done with pixels while they are read.
void setTransforms(png_structp png, const PngHeader &header, PngForm form) {
  if (header.isGrey) {
    png_set_packing(png); // Of fewer bits each takes a byte, and stays the number that it is.
    if (header.isWide() && std::endian::native == std::endian::little)
      png_set_swap(png);
    return;
  }
  png_set_expand(png);
  if (form == PngForm::Texels)
    png_set_alpha_mode(png, PNG_ALPHA_PNG, PNG_DEFAULT_sRGB);
  if (header.isWide())
    png_set_scale_16(png);
  if (!header.hasColour)
    png_set_gray_to_rgb(png);
  png_set_filler(png, 255, PNG_FILLER_AFTER);
}

/// Rows of pixels: false if they are broken.
bool readRows(png_structp png, png_infop info, const PngHeader &header, PngForm form, std::byte *target) {
  if (setjmp(png_jmpbuf(png)))
    return false;
  setTransforms(png, header, form);
  const int passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  const std::size_t row = header.rowBytes();
  if (png_get_rowbytes(png, info) != row)
    return false;
  for (int pass = 0; pass < passes; ++pass)
    for (std::uint32_t y = 0; y < header.height; ++y)
      png_read_row(png, reinterpret_cast<png_bytep>(target) + static_cast<std::size_t>(y) * row, nullptr);
  png_read_end(png, nullptr);
  return true;
}

/// What libpng does not report.
void findEnd(std::span<const std::byte> bytes, PngHeader &header) {
  constexpr std::size_t kSignature = 8, kAround = 12; // Length, type and checksum of a chunk.
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
    header.hasFrames |= type == "acTL";
    if (type == "IEND") {
      header.bytesBehind = rest.size();
      break;
    }
  }
}

PngHeader headerOf(png_structp png, png_infop info, PngForm form) {
  PngHeader header;
  header.width = png_get_image_width(png, info);
  header.height = png_get_image_height(png, info);
  const int kind = png_get_color_type(png, info);
  header.hasColour = (kind & PNG_COLOR_MASK_COLOR) != 0;
  header.hasAlpha = (kind & PNG_COLOR_MASK_ALPHA) != 0 || png_get_valid(png, info, PNG_INFO_tRNS) != 0;
  header.isGrey = form == PngForm::Samples && !header.hasColour && !header.hasAlpha;
  header.bits = png_get_bit_depth(png, info);
  png_uint_32 x = 0, y = 0;
  int unit = 0;
  if (png_get_pHYs(png, info, &x, &y, &unit) != 0)
    header.pixelsAUnit = {static_cast<double>(x), static_cast<double>(y)};
  return header;
}

class LibpngReader final : public PngReader {
public:
  LibpngReader(std::span<const std::byte> bytes, PngForm form) : source_{bytes}, form_(form) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source_, fail, ignore);
    info_ = png_ ? png_create_info_struct(png_) : nullptr;
  }
  ~LibpngReader() override {
    if (png_)
      png_destroy_read_struct(&png_, info_ ? &info_ : nullptr, nullptr);
  }
  LibpngReader(const LibpngReader &) = delete;
  LibpngReader &operator=(const LibpngReader &) = delete;

  Expected<void> open() {
    if (!info_)
      return Error::environment("out of memory for a PNG picture");
    const std::span<const std::byte> all = source_.bytes;
    if (all.size() < 8 || png_sig_cmp(reinterpret_cast<png_const_bytep>(all.data()), 0, 8))
      return Error::input("it is no PNG picture, or a broken one: it does not begin as one");
    png_set_read_fn(png_, &source_, readBytes);
    png_set_crc_action(png_, PNG_CRC_ERROR_QUIT, PNG_CRC_WARN_DISCARD);
    if (!readInfo(png_, info_))
      return Error::input(std::string("it is no PNG picture, or a broken one: ") + source_.problem.data());
    header_ = headerOf(png_, info_, form_);
    findEnd(all, header_);
    return {};
  }

  Expected<void> decode(std::span<std::byte> target) override {
    if (target.size() != header_.rowBytes() * header_.height)
      return Error::input("it has two sizes");
    if (!readRows(png_, info_, header_, form_, target.data()))
      return Error::input(source_.problem.data());
    return {};
  }

private:
  Source source_;
  PngForm form_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

} // namespace

Expected<std::unique_ptr<PngReader>> openPng(std::span<const std::byte> bytes, PngForm form) {
  auto reader = std::make_unique<LibpngReader>(bytes, form);
  if (auto opened = reader->open(); !opened)
    return opened.error();
  return std::unique_ptr<PngReader>(std::move(reader));
}

} // namespace voxc
