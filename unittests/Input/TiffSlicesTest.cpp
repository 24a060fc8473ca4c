// Slices of 16 bits, and pages of TIFF files as libtiff writes them.
#include "Input/Dense/ImageJ.h"
#include "Input/InputTesting.h"

#include "voxc/Input/Input.h"

#include <gmock/gmock.h>
#include <png.h>
#include <tiffio.h>

#include <cstring>

namespace voxc {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// How a page is written.
struct Layout {
  std::uint16_t bits = 8, samples = 1, format = SAMPLEFORMAT_UINT;
  std::uint16_t photometric = PHOTOMETRIC_MINISBLACK, planar = PLANARCONFIG_CONTIG;
  std::uint16_t compression = COMPRESSION_NONE;
  std::uint32_t tile = 0;
  bool hasAlpha = false;
  std::uint32_t subfile = 0;
  const char *mode = "w";
};

/// Appends a page of `width` x `height` whose rows (of each plane) are `bytes`.
void writePage(TIFF *tiff, std::uint32_t width, std::uint32_t height, const Layout &layout,
               std::string bytes) {
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, width);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, height);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, layout.bits);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, layout.samples);
  TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, layout.format);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, layout.photometric);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, layout.planar);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, layout.compression);
  TIFFSetField(tiff, TIFFTAG_SUBFILETYPE, layout.subfile);
  const std::uint16_t alpha = EXTRASAMPLE_UNASSALPHA;
  if (layout.hasAlpha)
    TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &alpha);
  if (layout.tile != 0) {
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, layout.tile);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, layout.tile);
    for (std::uint32_t y = 0; y < height; y += layout.tile)
      for (std::uint32_t x = 0; x < width; x += layout.tile) {
        std::string tile(static_cast<std::size_t>(TIFFTileSize(tiff)), '\0');
        for (std::uint32_t row = y; row < std::min(height, y + layout.tile); ++row)
          for (std::uint32_t column = x; column < std::min(width, x + layout.tile); ++column)
            tile[(row - y) * layout.tile + column - x] = bytes[row * width + column];
        TIFFWriteTile(tiff, tile.data(), x, y, 0, 0);
      }
  } else {
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 2);
    const int planes = layout.planar == PLANARCONFIG_SEPARATE ? layout.samples : 1;
    const auto row = static_cast<std::size_t>(TIFFScanlineSize(tiff));
    for (int plane = 0; plane < planes; ++plane)
      for (std::uint32_t y = 0; y < height; ++y)
        TIFFWriteScanline(tiff, bytes.data() + (static_cast<std::size_t>(plane) * height + y) * row, y,
                          static_cast<std::uint16_t>(plane));
  }
  TIFFWriteDirectory(tiff);
}

class TiffSlices : public OpenedInputs {
protected:
  TiffSlices() { options_.colourMap = "labels"; }

  /// A file of one page.
  std::vector<std::uint32_t> page(std::uint32_t width, std::uint32_t height, const Layout &layout,
                                  const std::string &bytes) {
    TIFF *const tiff = TIFFOpen(folder_.path("a.tif").c_str(), layout.mode);
    writePage(tiff, width, height, layout, bytes);
    TIFFClose(tiff);
    return words("a.tif");
  }
  template <typename Value> static std::string raw(std::initializer_list<Value> values) {
    return {reinterpret_cast<const char *>(values.begin()), values.size() * sizeof(Value)};
  }
};

using Words = std::vector<std::uint32_t>;

TEST_F(TiffSlices, GreySamplesOfAllKinds) {
  const Words expected{1, 2, 3, 4, 5, 6};
  const std::string bytes = "\1\2\3\4\5\6";
  EXPECT_EQ(page(3, 2, {}, bytes), expected);
  for (const std::uint16_t compression : {COMPRESSION_LZW, COMPRESSION_PACKBITS, COMPRESSION_ADOBE_DEFLATE})
    EXPECT_EQ(page(3, 2, {.compression = compression}, bytes), expected) << compression;
  EXPECT_EQ(page(3, 2, {.tile = 16}, bytes), expected);
  for (const char *const mode : {"wl", "wb", "w8"})
    EXPECT_EQ(page(3, 2, {.bits = 16, .mode = mode}, raw<std::uint16_t>({1, 2, 3, 400, 5000, 60000})),
              (Words{1, 2, 3, 400, 5000, 60000}))
        << mode;
  EXPECT_EQ(page(3, 2, {.bits = 32, .format = SAMPLEFORMAT_IEEEFP}, raw<float>({1, 2, 3, 4, 5, 6})),
            expected);
  EXPECT_EQ(page(3, 2, {.bits = 32, .format = SAMPLEFORMAT_INT}, raw<std::int32_t>({1, 2, 3, 4, 5, 6})),
            expected);
  EXPECT_EQ(page(3, 2, {.photometric = PHOTOMETRIC_MINISWHITE}, "\376\375\374\373\372\371"), expected);
  EXPECT_EQ(page(3, 2, {.bits = 1}, std::string("\xa0\x40", 2)), (Words{1, 0, 1, 0, 1, 0}));
  EXPECT_EQ(page(3, 2, {.bits = 4}, std::string("\x12\x30\x45\x60", 4)), expected);
}

TEST_F(TiffSlices, WhatPagesHaveIsTold) {
  const auto warningsOf = [&](std::uint16_t samples, std::uint16_t orientation, float yResolution,
                              const char *description) {
    TIFF *const tiff = TIFFOpen(folder_.path("a.tif").c_str(), "w");
    TIFFSetField(tiff, TIFFTAG_ORIENTATION, orientation);
    TIFFSetField(tiff, TIFFTAG_XRESOLUTION, 10.f);
    TIFFSetField(tiff, TIFFTAG_YRESOLUTION, yResolution);
    TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, description);
    const std::vector<std::uint16_t> kinds(samples, EXTRASAMPLE_UNSPECIFIED);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, samples); // Before those that are extra.
    if (samples > 1)
      TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, samples - 1, kinds.data());
    writePage(tiff, 2, 1, {.samples = samples}, "\1\2\3\4\5\6");
    TIFFClose(tiff);
    words("a.tif");
    return warnings_;
  };
  constexpr std::uint16_t kUpperLeft = ORIENTATION_TOPLEFT;
  EXPECT_THAT(warningsOf(1, kUpperLeft, 10, "by hand"), ::testing::IsEmpty());
  EXPECT_THAT(warningsOf(3, kUpperLeft, 10, "by hand"),
              ElementsAre("its pixels have 3 samples; those behind the first are left out"));
  EXPECT_THAT(warningsOf(1, ORIENTATION_BOTLEFT, 10, "by hand"), ElementsAre(HasSubstr("(orientation 4)")));
  EXPECT_THAT(warningsOf(1, kUpperLeft, 5, "by hand"), ElementsAre(HasSubstr("its pixels are no squares")));
  EXPECT_THAT(warningsOf(1, kUpperLeft, 10, "ImageJ=1.53\nimages=3\n"),
              ElementsAre("its description names 3 images, but it has 1 page; the others are left out"));
}

TEST_F(TiffSlices, Colours) {
  const Words expected{rgba(1, 2, 3), 0, rgba(4, 5, 6)};
  const Layout rgb{.samples = 3, .photometric = PHOTOMETRIC_RGB};
  EXPECT_EQ(page(3, 1, rgb, std::string("\1\2\3\0\0\0\4\5\6", 9)), expected);
  Layout apart = rgb;
  apart.planar = PLANARCONFIG_SEPARATE;
  EXPECT_EQ(page(3, 1, apart, std::string("\1\0\4\2\0\5\3\0\6", 9)), expected);
  Layout deep = rgb;
  deep.bits = 16;
  EXPECT_EQ(page(1, 1, deep, raw<std::uint16_t>({257, 514, 65535})), (Words{rgba(1, 2, 255)}));
  EXPECT_THAT(warnings_, ::testing::IsEmpty());
  // Numbers of 12 bits in 16 are not made brighter than they are, but told.
  EXPECT_EQ(page(1, 1, deep, raw<std::uint16_t>({4095, 1028, 0})), (Words{rgba(16, 4, 0)}));
  EXPECT_THAT(warnings_,
              ElementsAre(HasSubstr("are at most 4095, and dark, as 65535 is the brightest; if they "
                                    "are of 12 bits")));
  EXPECT_EQ(page(2, 1, {.samples = 4, .photometric = PHOTOMETRIC_RGB, .hasAlpha = true},
                 std::string("\1\2\3\4\0\0\0\0", 8)),
            (Words{rgba(1, 2, 3, 4), 0}));
  EXPECT_EQ(page(2, 1, {.samples = 2, .hasAlpha = true}, "\1\2\3\4"),
            (Words{rgba(1, 1, 1, 2), rgba(3, 3, 3, 4)}));
}

TEST_F(TiffSlices, PagesAndNumberedFilesAreStacks) {
  TIFF *tiff = TIFFOpen(folder_.path("stack.tiff").c_str(), "w");
  for (const char first : {'\1', '\3', '\5'})
    writePage(tiff, 2, 1, {}, {first, static_cast<char>(first + 1)});
  writePage(tiff, 1, 1, {.subfile = FILETYPE_REDUCEDIMAGE}, "x");
  TIFFClose(tiff);
  EXPECT_EQ(words("stack.tiff"), (Words{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(extent_, (Int3{2, 1, 3}));
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("1 page is left out, as masks or smaller copies")));
  for (const char *const name : {"s008.tif", "s009.tif", "s010.tif"}) {
    tiff = TIFFOpen(folder_.path(name).c_str(), "w");
    writePage(tiff, 1, 1, {}, {static_cast<char>(name[3] - '0' + 1)});
    TIFFClose(tiff);
  }
  EXPECT_EQ(words("s%03d.tif"), (Words{9, 10, 1}));
}

TEST_F(TiffSlices, WhatIsBrokenIsAnError) {
  const auto problem = [&](const std::string &content) {
    const auto input = openInput(folder_.file("b.tif", content), options_);
    return input ? std::string("none") : input.error().message;
  };
  EXPECT_THAT(problem("II*"), HasSubstr("is not a usable slice"));
  EXPECT_THAT(problem(std::string("II*\0\377\377\377\377", 8)),
              HasSubstr("it is no TIFF file that can be read"));
  TIFF *const tiff = TIFFOpen(folder_.path("a.tif").c_str(), "w");
  writePage(tiff, 3, 2, {}, "\1\2\3\4\5\6");
  writePage(tiff, 2, 3, {}, "\1\2\3\4\5\6");
  TIFFClose(tiff);
  EXPECT_THAT(openInput(folder_.path("a.tif"), options_).error().message,
              HasSubstr("another size than the first"));
  TIFF *const odd = TIFFOpen(folder_.path("c.tif").c_str(), "w");
  writePage(odd, 3, 2, {.bits = 24}, std::string(18, 'x'));
  TIFFClose(odd);
  EXPECT_THAT(openInput(folder_.path("c.tif"), options_).error().message, HasSubstr("samples of 24 bits"));
}

TEST_F(TiffSlices, PngOf16Bits) {
  const std::array<std::uint16_t, 3> samples{1, 300, 60000};
  const std::string path = folder_.path("a%02d.png");
  for (const char *const name : {"a10.png", "a11.png"}) {
    std::FILE *const file = std::fopen(folder_.path(name).c_str(), "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_IHDR(png, info, 3, 1, 16, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    png_set_swap(png);
    png_write_row(png, reinterpret_cast<png_const_bytep>(samples.data()));
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    std::fclose(file);
  }
  EXPECT_EQ(words("a%02d.png"), (Words{1, 300, 60000, 1, 300, 60000}));
}

TEST_F(TiffSlices, SpacingOfImageJ) {
  const auto open = [&](const std::string &description, float resolution, const Layout &layout,
                        const std::string &bytes) {
    TIFF *const tiff = TIFFOpen(folder_.path("j.tif").c_str(), "w");
    for (int page = 0; page < 2; ++page) {
      if (page == 0)
        TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, description.c_str());
      TIFFSetField(tiff, TIFFTAG_XRESOLUTION, resolution);
      TIFFSetField(tiff, TIFFTAG_YRESOLUTION, 2 * resolution);
      writePage(tiff, 2, 1, layout, bytes);
    }
    TIFFClose(tiff);
    words("j.tif");
    return std::array<double, 3>{map_[0][0], map_[1][1], map_[2][2]};
  };
  const Layout rgb{.samples = 3, .photometric = PHOTOMETRIC_RGB};
  options_.isAutomatic = true; // Which warns of voxels that are no cubes.
  const std::string stack = "ImageJ=1.53t\nimages=2\nslices=2\n";
  EXPECT_EQ(open(stack + "unit=micron\nspacing=0.75\nloop=false\n", 4, {}, "\1\2"),
            (std::array<double, 3>{0.25, 0.125, 0.75}));
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("its voxels are 0.25 x 0.125 x 0.75 and no cubes")));
  EXPECT_EQ(open(stack + "unit=mm\n", 4, rgb, "\1\2\3\4\5\6"), (std::array<double, 3>{0.25, 0.125, 1}));
  EXPECT_EQ(open(stack + "spacing=-2\n", 1, {}, "\1\2"), (std::array<double, 3>{1, 0.5, 2}));
  // Nothing is said of lengths, or by another program.
  EXPECT_EQ(open(stack, 4, {}, "\1\2"), (std::array<double, 3>{1, 1, 1}));
  EXPECT_EQ(open(stack + "unit=pixel\nspacing=x\n", 4, {}, "\1\2"), (std::array<double, 3>{1, 1, 1}));
  EXPECT_EQ(open("spacing=3\nunit=mm\n", 4, {}, "\1\2"), (std::array<double, 3>{1, 1, 1}));
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("its pixels are no squares (1 : 0.5, width to height)")));
  // Cubes of a length, of colours too.
  options_.voxelSize = {0.125, 1e-3};
  open(stack + "unit=mm\nspacing=0.25\n", 4, rgb, "\1\2\3\4\5\6");
  EXPECT_EQ(extent_, (Int3{4, 1, 4}));
  options_.colourMap = "grey";
  options_.voxelSize = {250, 1e-9};
  open(stack + "unit=\\u00B5m\nspacing=0.25\n", 2, {}, "\1\2");
  EXPECT_EQ(extent_, (Int3{4, 1, 2}));
}

TEST(ImageJ, Units) {
  for (const char *const unit : {"micron", "um", "\xc2\xb5m", "\xce\xbcm", "\xb5m", "\\u00B5m"})
    EXPECT_EQ(imageJSpacing("ImageJ=1\nunit=" + std::string(unit) + "\r\n", {1, 0})->metres, 1e-6) << unit;
  EXPECT_EQ(imageJSpacing("ImageJ=1\nunit=inch\nspacing=inf\n", {0, -1}), (StackSpacing{{1, 1, 1}, 0.0254}));
  EXPECT_EQ(imageJSpacing("ImageJ=1\nunit=cubit\nspacing=0\n", {1e300, 5})->metres, 0);
  EXPECT_FALSE(imageJSpacing("", {1, 1}));
}

} // namespace
} // namespace voxc
