// Images of every kind, and such that are none.
#include "Image/ImageDecoder.h"

#include <gmock/gmock.h>

#include <array>
#include <fstream>
#include <string>
#include <vector>

namespace voxc {
namespace {

using testing::HasSubstr;

std::string contentOf(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::uint32_t> texelsOf(const DecodedImage &image) {
  return {image.texels.span().begin(), image.texels.span().end()};
}

class Images : public testing::Test {
protected:
  Expected<DecodedImage> decode(const std::string &bytes) {
    return decoder_.decode({reinterpret_cast<const std::byte *>(bytes.data()), bytes.size()});
  }
  Expected<DecodedImage> decodeFile(const std::string &name) {
    return decode(contentOf(VOXC_UNITTESTS_DIR "/Mesh/Corpus/image/" + name));
  }
  std::string problem(const std::string &name) {
    const auto image = decodeFile(name);
    return image ? "no error" : image.error().message;
  }

  ImageDecoder decoder_{WorkingMemory::create(std::uint64_t{64} << 20)};
};

TEST_F(Images, EveryKind) {
  for (const char *name : {"a.png", "a.bmp", "a.tga"}) {
    const auto image = decodeFile(name);
    ASSERT_TRUE(image) << name << ": " << image.error().message;
    EXPECT_EQ(image->width, 2) << name;
    EXPECT_EQ(texelsOf(*image), (std::vector<std::uint32_t>{0xff0000ff, 0xff00ff00, 0xffff0000, 0xffffffff}))
        << name;
  }
}

TEST_F(Images, JpegOfBothKinds) {
  for (const char *name : {"a.jpg", "progressive.jpg"}) {
    const auto image = decodeFile(name);
    ASSERT_TRUE(image) << name << ": " << image.error().message;
    EXPECT_EQ(image->width, 17);
    EXPECT_EQ(image->height, 9);
    // One colour, 200 100 50, but for what JPEG loses.
    for (const std::uint32_t texel : texelsOf(*image)) {
      EXPECT_NEAR(texel & 255, 200, 6) << name;
      EXPECT_NEAR(texel >> 8 & 255, 100, 6) << name;
      EXPECT_NEAR(texel >> 16 & 255, 50, 6) << name;
      EXPECT_EQ(texel >> 24, 255u);
    }
  }
  EXPECT_GT(decoder_.libraryPeakBytes(), 0u);
}

TEST_F(Images, JpegsOfInks) {
  // Cyan, magenta, yellow and black as Adobe's programs store them, the same in YCCK, and as others do.
  for (const char *name : {"adobe-cmyk.jpg", "adobe-ycck.jpg", "plain-cmyk.jpg"}) {
    const auto image = decodeFile(name);
    ASSERT_TRUE(image) << name << ": " << image.error().message;
    const std::vector<std::uint32_t> texels = texelsOf(*image);
    ASSERT_EQ(texels.size(), 256u);
    // Red, green, blue, and a yellow that black makes half as bright.
    const std::array<std::uint32_t, 4> expected{0xff0000ff, 0xff00ff00, 0xffff0000, 0xff008080};
    for (std::size_t i = 0; i < texels.size(); ++i)
      for (int bit = 0; bit < 32; bit += 8)
        EXPECT_NEAR(texels[i] >> bit & 255, expected[i / 128 * 2 + i % 16 / 8] >> bit & 255, 6) << name << i;
  }
}

TEST_F(Images, SixteenBitsAndPalettes) {
  // Colours are taken as they are: no gamma.
  auto image = decodeFile("gray16.png");
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(texelsOf(*image), (std::vector<std::uint32_t>{0xff808080, 0xff101010}));
  image = decodeFile("palette.png");
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(texelsOf(*image), (std::vector<std::uint32_t>{0xff00ff00, 0x800000ff}));
}

/// Of what a picture says of its gamma, formats ask or do not: glTF does not.
TEST_F(Images, NumbersMayStayAsTheyAreStored) {
  std::string bytes = contentOf(VOXC_UNITTESTS_DIR "/Mesh/Corpus/image/gray16.png");
  constexpr std::size_t kBehindHeader = 33;
  bytes.insert(kBehindHeader, std::string("\0\0\0\4gAMA\0\1\206\240\61\350\226\137", 16)); // 1.
  const auto said = decode(bytes);
  ASSERT_TRUE(said) << said.error().message;
  EXPECT_EQ(texelsOf(*said)[0], 0xffbababa);
  ImageDecoder stored(WorkingMemory::create(std::uint64_t{1} << 20), ImageNumbers::Stored);
  const auto image = stored.decode({reinterpret_cast<const std::byte *>(bytes.data()), bytes.size()});
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(texelsOf(*image), (std::vector<std::uint32_t>{0xff808080, 0xff101010}));
}

/// The header of a TGA says how many of its bits are alpha.
TEST_F(Images, OfATgaWithoutAlphaTheFourthByteIsNone) {
  std::string bytes("\0\0\2\0\0\0\0\0\0\0\0\0\2\0\1\0\40\40\0\0\377\0\0\377\0\100", 26);
  const auto image = decode(bytes);
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(texelsOf(*image), (std::vector<std::uint32_t>{0xff0000ff, 0xff00ff00}));
  bytes[17] = '\50';
  EXPECT_EQ(texelsOf(*decode(bytes)), (std::vector<std::uint32_t>{0x000000ff, 0x4000ff00}));
}

TEST_F(Images, BrokenOnesSayWhy) {
  EXPECT_THAT(problem("empty.png"), HasSubstr("no PNG, JPEG, WebP, BMP or TGA"));
  EXPECT_THAT(problem("wide.png"), HasSubstr("20000x1 texels, but none may have more than 16384 a side"));
  EXPECT_THAT(problem("claims.png"), HasSubstr("16000x16000 texels, more than its 66 bytes can hold"));
  EXPECT_THAT(problem("huge.tga"), HasSubstr("16383x16383 texels, more than its 18 bytes can hold"));
  EXPECT_THAT(problem("size.jpg"), HasSubstr("40000x40000 texels, but none may have more than 16384 a side"));
  for (const char *name : {"cut.png", "no-rows.png"})
    EXPECT_THAT(problem(name), HasSubstr("the image is broken: ")) << name;
  for (const char *name : {"cut.bmp", "header.jpg", "tables.jpg"})
    EXPECT_THAT(problem(name), HasSubstr("or a broken one")) << name;
}

TEST_F(Images, JpegsWithTooManyScans) {
  std::string bytes = contentOf(VOXC_UNITTESTS_DIR "/Mesh/Corpus/image/a.jpg");
  for (int i = 0; i < 101; ++i)
    bytes += "\xff\xda";
  const auto image = decode(bytes);
  ASSERT_FALSE(image);
  EXPECT_THAT(image.error().message, HasSubstr("more than 100 scans"));
}

} // namespace
} // namespace voxc
