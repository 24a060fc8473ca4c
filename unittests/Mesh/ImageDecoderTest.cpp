// Images of every kind, and such that are none.
#include "Mesh/Image/ImageDecoder.h"

#include "LoadTesting.h"

#include <gmock/gmock.h>

namespace voxc {
namespace {

using testing::HasSubstr;

std::string contentOf(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

class Images : public testing::Test {
protected:
  Expected<Texture> decode(const std::string &bytes) {
    return decoder_.decode({reinterpret_cast<const std::byte *>(bytes.data()), bytes.size()});
  }
  Expected<Texture> decodeFile(const std::string &name) {
    return decode(contentOf(VOXC_UNITTESTS_DIR "/Mesh/Corpus/image/" + name));
  }
  std::string problem(const std::string &name) {
    const auto texture = decodeFile(name);
    return texture ? "no error" : texture.error().message;
  }

  ImageDecoder decoder_{WorkingMemory::create(std::uint64_t{64} << 20)};
};

TEST_F(Images, EveryKind) {
  for (const char *name : {"a.png", "a.bmp", "a.tga"}) {
    const auto texture = decodeFile(name);
    ASSERT_TRUE(texture) << name << ": " << texture.error().message;
    EXPECT_EQ(texture->width, 2) << name;
    EXPECT_EQ(texelsOf(*texture),
              (std::vector<std::uint32_t>{0xff0000ff, 0xff00ff00, 0xffff0000, 0xffffffff}))
        << name;
  }
}

TEST_F(Images, JpegOfBothKinds) {
  for (const char *name : {"a.jpg", "progressive.jpg"}) {
    const auto texture = decodeFile(name);
    ASSERT_TRUE(texture) << name << ": " << texture.error().message;
    EXPECT_EQ(texture->width, 17);
    EXPECT_EQ(texture->height, 9);
    // One colour, 200 100 50, but for what JPEG loses.
    for (const std::uint32_t texel : texelsOf(*texture)) {
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
    const auto texture = decodeFile(name);
    ASSERT_TRUE(texture) << name << ": " << texture.error().message;
    const std::vector<std::uint32_t> texels = texelsOf(*texture);
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
  auto texture = decodeFile("gray16.png");
  ASSERT_TRUE(texture) << texture.error().message;
  EXPECT_EQ(texelsOf(*texture), (std::vector<std::uint32_t>{0xff808080, 0xff101010}));
  texture = decodeFile("palette.png");
  ASSERT_TRUE(texture) << texture.error().message;
  EXPECT_EQ(texelsOf(*texture), (std::vector<std::uint32_t>{0xff00ff00, 0x800000ff}));
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
  const auto texture = decode(bytes);
  ASSERT_FALSE(texture);
  EXPECT_THAT(texture.error().message, HasSubstr("more than 100 scans"));
}

} // namespace
} // namespace voxc
