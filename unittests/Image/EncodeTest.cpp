// Pictures encoded, and what readers find in them.
#include "voxc/Image/Encode.h"

#include "Image/ImageDecoder.h"
#include "Image/PngReader.h"
#include "ResidentMemory.h"

#include <gmock/gmock.h>
#include <zlib.h>

#include <array>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace voxc {
namespace {

constexpr int kWidth = 40, kHeight = 24;

/// A gradient, opaque; smooth, so that a JPEG loses little of it.
std::vector<std::uint32_t> gradient() {
  std::vector<std::uint32_t> words;
  for (std::uint32_t y = 0; y < kHeight; ++y)
    for (std::uint32_t x = 0; x < kWidth; ++x)
      words.push_back(0xff000000 | (2 * x + y) << 16 | 5 * y << 8 | 4 * x);
  return words;
}

std::span<const std::byte> bytesOf(const std::string &text) {
  return {reinterpret_cast<const std::byte *>(text.data()), text.size()};
}

std::vector<std::uint32_t> decoded(const Expected<std::string> &bytes) {
  EXPECT_TRUE(bytes) << bytes.error().message;
  ImageDecoder decoder(WorkingMemory::create(std::uint64_t{64} << 20));
  const auto image = decoder.decode(bytesOf(*bytes));
  EXPECT_TRUE(image) << image.error().message;
  EXPECT_EQ(image->width, kWidth);
  EXPECT_EQ(image->height, kHeight);
  return {image->texels.span().begin(), image->texels.span().end()};
}

TEST(Encode, PngHasThePixels) {
  std::vector<std::uint32_t> words = gradient();
  words[7] = 0x40ff8001;
  words[8] = 0x00123456;
  EXPECT_EQ(decoded(encodePng(words, kWidth, kHeight)), words);
}

TEST(Encode, PngIsReadAsASlice) {
  std::vector<std::uint32_t> words = gradient();
  const auto bytes = encodePng(words, kWidth, kHeight);
  ASSERT_TRUE(bytes) << bytes.error().message;
  const auto reader = openPng(bytesOf(*bytes), PngForm::Samples);
  ASSERT_TRUE(reader) << reader.error().message;
  const PngHeader &header = (*reader)->header();
  EXPECT_TRUE(header.hasColour && header.hasAlpha && !header.isGrey && !header.isWide());
  EXPECT_EQ(header.bytesBehind, 0u);
  ASSERT_EQ(header.rowBytes() * header.height, words.size() * 4);
  std::vector<std::uint32_t> read(words.size());
  ASSERT_TRUE((*reader)->decode(std::as_writable_bytes(std::span(read))));
  EXPECT_EQ(read, words);
}

/// A chunk of a PNG with a long text, compressed.
std::string textChunk(std::size_t length) {
  const std::string text(length, 'a');
  uLongf size = compressBound(text.size());
  std::string packed(size, '\0');
  compress(reinterpret_cast<Bytef *>(packed.data()), &size, reinterpret_cast<const Bytef *>(text.data()),
           text.size());
  const std::string body = std::string("zTXta\0\0", 7) + packed.substr(0, size);
  const auto number = [](unsigned long value) {
    std::string digits;
    for (int shift = 24; shift >= 0; shift -= 8)
      digits += static_cast<char>(value >> shift & 255);
    return digits;
  };
  return number(body.size() - 4) + body +
         number(crc32(0, reinterpret_cast<const Bytef *>(body.data()), static_cast<uInt>(body.size())));
}

TEST(Encode, TextsOfAPngAreNotRead) {
  const std::vector<std::uint32_t> words = gradient();
  const auto bytes = encodePng(words, kWidth, kHeight);
  ASSERT_TRUE(bytes) << bytes.error().message;
  constexpr std::size_t kBehindHeader = 33;
  const std::string text = textChunk(7'000'000);
  std::string full = *bytes;
  for (int i = 0; i < 24; ++i)
    full.insert(kBehindHeader, text);
  const std::uint64_t before = test::residentBytes();
  const auto reader = openPng(bytesOf(full), PngForm::Samples);
  ASSERT_TRUE(reader) << reader.error().message;
  EXPECT_LT(test::residentBytes(), before + (std::uint64_t{64} << 20));
  EXPECT_EQ(decoded(full), words);
}

TEST(Encode, JpegHasThemNearly) {
  const std::vector<std::uint32_t> words = gradient();
  for (const auto &[quality, most] : {std::pair{95, 4}, std::pair{80, 16}}) {
    const auto texels = decoded(encodeJpeg(words, kWidth, kHeight, quality));
    ASSERT_EQ(texels.size(), words.size());
    for (std::size_t i = 0; i < words.size(); ++i)
      for (int bit = 0; bit < 32; bit += 8)
        ASSERT_NEAR(int(texels[i] >> bit & 255), int(words[i] >> bit & 255), most) << i;
  }
}

TEST(Encode, JpegOfTooManyPixelsIsAnError) {
  const auto bytes = encodeJpeg(std::vector<std::uint32_t>(65501), 65501, 1, 90);
  ASSERT_FALSE(bytes);
  EXPECT_THAT(bytes.error().message, testing::HasSubstr("65500"));
}

TEST(Encode, ExrOfColoursIsLinearAndOpaque) {
  // One white pixel and one black: the last row has A, B, G and R of both.
  const std::string bytes = encodeExr(std::vector<std::uint32_t>{0xffffffff, 0}, 2, 1);
  std::array<float, 8> row;
  ASSERT_GT(bytes.size(), sizeof row);
  std::memcpy(row.data(), bytes.data() + bytes.size() - sizeof row, sizeof row);
  EXPECT_THAT(row, testing::ElementsAre(1, 1, 1, 0, 1, 0, 1, 0));
}

} // namespace
} // namespace voxc
