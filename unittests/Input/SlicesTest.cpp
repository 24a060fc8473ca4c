// Slices come back as they were written; grey ones are samples; broken ones are errors.
#include "Source/SourceTesting.h"

#include "voxc/Input/Input.h"
#include "voxc/Source/Export.h"

#include <gmock/gmock.h>
#include <png.h>

#include <cstring>

namespace voxc {
namespace {

using ::testing::HasSubstr;

/// Writes a picture of `width` x `height` in a format of libpng.
void writePng(const std::string &path, unsigned width, unsigned height, unsigned format, const void *cells) {
  png_image image;
  std::memset(&image, 0, sizeof image);
  image.version = PNG_IMAGE_VERSION;
  image.width = width;
  image.height = height;
  image.format = format;
  ASSERT_TRUE(png_image_write_to_file(&image, path.c_str(), 0, cells, 0, nullptr)) << image.message;
}

Volume volumeOf(std::vector<std::uint32_t> cells) {
  VolumeInfo info;
  info.format = *parseFormat("R(2, 2, 1)");
  info.extent = {4, 4, 2};
  for (const std::uint32_t word : cells)
    info.voxels += word != 0;
  cells.insert(cells.begin(), 1);
  return Volume(info, cells);
}

TEST(Slices, ComeBackWordByWord) {
  const TemporaryFolder folder;
  std::vector<std::uint32_t> cells(32);
  for (std::uint32_t i = 0; i < 32; ++i)
    cells[i] = i % 3 == 0 ? 0 : i * 0x01030507; // Some of little alpha.
  cells[1] = 0x00000001;
  const auto exported = exportVoxels(volumeOf(cells), folder.path("s%03d.png"));
  ASSERT_TRUE(exported) << exported.error().message;
  EXPECT_EQ(exported->files, 2u);
  EXPECT_TRUE(std::filesystem::exists(folder.path("s001.png")));
  const auto input = openInput(folder.path("s%03d.png"), {});
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(input->source->extent(), (Int3{4, 4, 2}));
  Voxels expected;
  for (int i = 0; i < 32; ++i)
    if (cells[static_cast<std::size_t>(i)] != 0)
      expected[mortonCode({i % 4, i / 4 % 4, i / 16})] = cells[static_cast<std::size_t>(i)];
  EXPECT_EQ(voxelsOf(*input->source), expected);
}

/// Writes a row of 16 greys of `bits` bits each.
void writeGreys(const std::string &path, int bits, std::vector<unsigned char> rows) {
  std::FILE *file = std::fopen(path.c_str(), "wb");
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, file);
  png_set_IHDR(png, info, 16, 1, bits, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  png_write_row(png, rows.data());
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  std::fclose(file);
}

TEST(Slices, GreysOfFewBitsAreTheirNumbers) {
  const TemporaryFolder folder;
  InputOptions options;
  options.colourMap = "labels";
  writeGreys(folder.path("four.png"), 4, {0x01, 0x23, 0x45, 0x67, 0x89, 0xab, 0xcd, 0xef});
  const auto four = openInput(folder.path("four.png"), options);
  ASSERT_TRUE(four) << four.error().message;
  Voxels expected;
  for (int i = 1; i < 16; ++i)
    expected[mortonCode({i, 0, 0})] = static_cast<std::uint32_t>(i);
  EXPECT_EQ(voxelsOf(*four->source), expected);
  writeGreys(folder.path("one.png"), 1, {0x80, 0x01});
  const auto one = openInput(folder.path("one.png"), options);
  ASSERT_TRUE(one) << one.error().message;
  EXPECT_EQ(voxelsOf(*one->source), (Voxels{{0, 1}, {mortonCode({15, 0, 0}), 1}}));
}

/// Programs that make pictures small give each as few bits as it needs.
TEST(Slices, GreysOfSeveralBitsGoFromBlackToWhite) {
  const TemporaryFolder folder;
  InputOptions options;
  options.colourMap = "labels";
  writeGreys(folder.path("a0.png"), 1, {0x80, 0});
  writeGreys(folder.path("a1.png"), 4, {0x02, 0, 0, 0, 0, 0, 0, 0xf0});
  std::vector<unsigned char> bytes(16);
  bytes[5] = 77;
  writeGreys(folder.path("a2.png"), 8, bytes);
  writeGreys(folder.path("a3.png"), 1, {0, 0x01});
  const auto input = openInput(folder.path("a%d.png"), options);
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(voxelsOf(*input->source), (Voxels{{0, 255},
                                              {mortonCode({1, 0, 1}), 34},
                                              {mortonCode({14, 0, 1}), 255},
                                              {mortonCode({5, 0, 2}), 77},
                                              {mortonCode({15, 0, 3}), 255}}));
  EXPECT_THAT(input->warnings, ::testing::ElementsAre(HasSubstr("all are taken as of 8")));
}

TEST(Slices, GreyOnesAreSamples) {
  const TemporaryFolder folder;
  const std::array<unsigned char, 4> low{0, 10, 20, 30};
  const std::array<unsigned char, 4> high{200, 0, 0, 0};
  writePng(folder.path("a1.png"), 2, 2, PNG_FORMAT_GRAY, low.data());
  writePng(folder.path("a2.png"), 2, 2, PNG_FORMAT_GRAY, high.data());
  InputOptions options;
  options.threshold = 20;
  const auto input = openInput(folder.path("a%d.png"), options);
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(input->provenance.substr(0, 29), "coverage=samples threshold=20");
  const Voxels voxels = voxelsOf(*input->source);
  EXPECT_EQ(voxels.size(), 3u);
  EXPECT_TRUE(voxels.contains(mortonCode({0, 0, 1})));
}

TEST(Slices, OfPicturesWithoutAlphaBlackIsEmpty) {
  const TemporaryFolder folder;
  const std::array<unsigned char, 6> cells{0, 0, 0, 3, 0, 0};
  writePng(folder.path("a.png"), 2, 1, PNG_FORMAT_RGB, cells.data());
  const auto input = openInput(folder.path("a.png"), {});
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(voxelsOf(*input->source), (Voxels{{mortonCode({1, 0, 0}), 0xff000003}}));
}

TEST(Slices, WhatIsBrokenIsAnError) {
  const TemporaryFolder folder;
  const std::array<std::uint32_t, 4> cells{1, 2, 3, 4};
  writePng(folder.path("a0.png"), 2, 2, PNG_FORMAT_RGBA, cells.data());
  writePng(folder.path("a1.png"), 4, 1, PNG_FORMAT_RGBA, cells.data());
  const auto message = [&](const char *name) { return openInput(folder.path(name), {}).error().message; };
  EXPECT_THAT(message("a%d.png"), HasSubstr("a1.png' is not a usable slice: it has another size"));
  EXPECT_THAT(message("b%d.png"), HasSubstr("names no file"));
  folder.file("c0.png", "nonsense");
  EXPECT_THAT(message("c0.png"), HasSubstr("is not a usable slice: it is no PNG"));
  std::ifstream whole(folder.path("a0.png"), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(whole), {}};
  folder.file("d0.png", bytes.substr(0, bytes.size() - 30));
  EXPECT_THAT(message("d0.png"), HasSubstr("is not a usable slice"));
  InputOptions small;
  small.formatExtent = {1, 8, 8};
  EXPECT_THAT(openInput(folder.path("a0.png"), small).error().message, HasSubstr("the format holds 1x8x8"));
}

TEST(Slices, SeveralNeedAPattern) {
  const TemporaryFolder folder;
  const auto exported = exportVoxels(volumeOf(std::vector<std::uint32_t>(32, 5)), folder.path("s.png"));
  ASSERT_FALSE(exported);
  EXPECT_THAT(exported.error().message, HasSubstr("%04d"));
  EXPECT_EQ(folder.count(), 0);
}

} // namespace
} // namespace voxc
