// Dense volumes: NRRD, raw samples and binvox, and how samples become voxels.
#include "Input/DenseTesting.h"
#include "Mesh/SharedModels.h"

#include "voxc/Input/Input.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>

namespace voxc {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST_F(DenseVolumes, AllButZeroAreVoxelsUnlessThereIsAThreshold) {
  const std::string samples = bytesOf<std::int8_t>({-1, 0, 1, 3});
  EXPECT_EQ(raw("4x1x1:int8", samples), (Voxels{{mortonCode({0, 0, 0}), kBlack},
                                                {mortonCode({2, 0, 0}), 0xff808080},
                                                {mortonCode({3, 0, 0}), kWhite}}));
  EXPECT_EQ(provenance_, "coverage=samples colour-map=grey window=-1,3 up=y");
  options_.threshold = 1;
  EXPECT_EQ(raw("4x1x1:int8", samples).size(), 2u);
  EXPECT_EQ(provenance_, "coverage=samples threshold=1 colour-map=grey window=-1,3 up=y");
  options_.threshold = 0;
  EXPECT_EQ(raw("4x1x1:int8", samples).size(), 3u);
}

TEST_F(DenseVolumes, LabelsAreTheSamples) {
  options_.colourMap = "labels";
  EXPECT_EQ(
      raw("4x1x1:uint16le", bytesOf<std::uint16_t>({1, 0, 300, 65535})),
      (Voxels{{mortonCode({0, 0, 0}), 1}, {mortonCode({2, 0, 0}), 300}, {mortonCode({3, 0, 0}), 65535}}));
  EXPECT_EQ(provenance_, "coverage=samples colour-map=labels up=y");
  // What is no label is a voxel of none, which a build of labels refuses.
  EXPECT_EQ(raw("4x1x1:float32le", bytesOf<float>({-1, 0.5F, 7, 65536})),
            (Voxels{{mortonCode({0, 0, 0}), kWhite},
                    {mortonCode({1, 0, 0}), kWhite},
                    {mortonCode({2, 0, 0}), 7},
                    {mortonCode({3, 0, 0}), kWhite}}));
}

TEST_F(DenseVolumes, WindowAndColourMapMakeColours) {
  options_.window = {{1, 3}};
  EXPECT_EQ(raw("4x1x1:uint8", bytesOf<std::uint8_t>({1, 2, 3, 200})),
            (Voxels{{0, kBlack}, {1, 0xff808080}, {8, kWhite}, {9, kWhite}}));
  options_.colourMap = "heat";
  const Voxels heat = raw("2x1x1:uint8", bytesOf<std::uint8_t>({1, 3}));
  EXPECT_EQ(heat, (Voxels{{0, rgba(20, 8, 12)}, {1, rgba(255, 252, 224)}}));
  options_.colourMap = "rainbow";
  EXPECT_THAT(problem("a.nrrd", ""), HasSubstr("NRRD"));
  const auto input = openInput("raw:1x1x1:uint8:" + folder_.file("b", "1"), options_);
  ASSERT_FALSE(input);
  EXPECT_EQ(input.error().message,
            "there is no colour map 'rainbow'; there are grey, heat, dusk, polar and, for labels, labels");
  options_.colourMap = "grey";
  options_.window = {{3, 1}};
  EXPECT_THAT(openInput("raw:1x1x1:uint8:" + folder_.file("b", "1"), options_).error().message,
              HasSubstr("first number must be the lower one"));
}

TEST_F(DenseVolumes, NumbersThatAreNoneAndEndsOfRanges) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  // The one finite number is both ends of the range.
  const Voxels expected{{0, kWhite}, {8, kWhite}};
  EXPECT_EQ(raw("4x1x1:float32le", bytesOf<float>({-2, nan, inf, -inf})), expected);
  const double most = std::numeric_limits<double>::max();
  EXPECT_EQ(raw("3x1x1:float64le", bytesOf<double>({-most, 0, most})), (Voxels{{0, kBlack}, {8, kWhite}}));
  EXPECT_EQ(raw("2x1x1:float32le", bytesOf<float>({nan, nan})), Voxels());
  EXPECT_EQ(raw("2x1x1:uint16le", bytesOf<std::uint16_t>({7, 7})), (Voxels{{0, kWhite}, {1, kWhite}}));
}

TEST_F(DenseVolumes, SamplesOfAllTypesAndByteOrders) {
  const auto expectType = [&]<typename Value>(const std::string &name, Value high) {
    const Value low = high / 5;
    for (const bool bigEndian : {false, true}) {
      const std::string type = name + (sizeof(Value) == 1 ? "" : bigEndian ? "be" : "le");
      EXPECT_EQ(raw("3x1x1:" + type, bytesOf<Value>({Value{0}, high, low}, bigEndian)),
                (Voxels{{1, kWhite}, {8, 0xff333333}}))
          << type;
    }
  };
  expectType("int8", std::int8_t{125});
  expectType("uint8", std::uint8_t{250});
  expectType("int16", std::int16_t{32000});
  expectType("uint16", std::uint16_t{65000});
  expectType("int32", std::int32_t{2000000000});
  expectType("uint32", std::uint32_t{4000000000});
  expectType("int64", std::int64_t{9000000000000000000});
  expectType("uint64", std::uint64_t{15000000000000000000u});
  expectType("float32", 1e-30f);
  expectType("float64", 1e-300);
}

TEST_F(DenseVolumes, AxesAreAsTheyLieUnlessUpIsZ) {
  std::string samples(3 * 4 * 5, '\0');
  samples[2 + 3 * (1 + 4 * 4)] = 9;
  EXPECT_EQ(raw("3x4x5:uint8", samples), (Voxels{{mortonCode({2, 1, 4}), kWhite}}));
  EXPECT_EQ(extent_, (Int3{3, 4, 5}));
  EXPECT_THAT(toModel(2, 1, 4), ElementsAre(2, 1, 4));
  options_.zUp = true;
  EXPECT_EQ(raw("3x4x5:uint8", samples), (Voxels{{mortonCode({2, 4, 2}), kWhite}}));
  EXPECT_EQ(extent_, (Int3{3, 5, 4}));
  // The middle of the voxel is that of the sample.
  EXPECT_THAT(toModel(2.5, 4.5, 2.5), ElementsAre(2.5, 1.5, 4.5));
}

std::string nrrdOfBytes(const std::string &fields, const std::string &data = "\1\2\3\4\5\6") {
  return "NRRD0004\n# a comment\ntype: uint8\ndimension: 3\nsizes: 3 2 1\n" + fields + "\n" + data;
}

TEST_F(DenseVolumes, WhatIsNoNumberIsBackground) {
  std::vector<float> samples(1000, std::nanf(""));
  for (std::size_t i = 0; i < 400; ++i)
    samples[i] = 100 + static_cast<float>(i) / 40;
  std::string bytes(samples.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), samples.data(), bytes.size());
  options_.isAutomatic = true;
  EXPECT_EQ(raw("10x10x10:float32le", bytes).size(), 400u);
  EXPECT_TRUE(notes_.empty());
  // So is the logarithm of 0.
  std::replace_if(
      samples.begin(), samples.end(), [](float sample) { return std::isnan(sample); },
      -std::numeric_limits<float>::infinity());
  std::string logarithms(bytes.size(), '\0');
  std::memcpy(logarithms.data(), samples.data(), bytes.size());
  EXPECT_EQ(raw("10x10x10:float32le", logarithms).size(), 400u);
  EXPECT_EQ(raw("10x10x10:float32le", bytes).size(), 400u);
  options_.describe = true;
  const auto input = openInput("raw:10x10x10:float32le:" + folder_.path("samples.bin"), options_);
  ASSERT_TRUE(input) << input.error().message;
  std::map<std::string, std::string> facts;
  for (const InputFact &fact : input->facts)
    facts[fact.name] = fact.text;
  EXPECT_EQ(facts["zeros"], "0, 0.0 %");
  EXPECT_EQ(facts["no numbers"], "600, 60.0 %");
}

TEST_F(DenseVolumes, RangesBeyondAllNumbersHaveAThreshold) {
  options_.isAutomatic = true;
  EXPECT_EQ(raw("3x1x1:float64le", bytesOf<double>({-1e308, 1e308, 5})).size(), 2u);
}

TEST_F(DenseVolumes, ColoursThatAreBytesOfAWiderType) {
  const std::string head = "NRRD0004\ndimension: 4\nsizes: 3 2 1 1\nencoding: raw\nendian: little\n"
                           "kinds: RGB-color domain domain domain\n";
  const std::string shorts = bytesOf<std::uint16_t>({1, 2, 3, 100, 200, 249});
  const Voxels bytes{{0, rgba(1, 2, 3)}, {1, rgba(100, 200, 249)}};
  EXPECT_EQ(voxels("a.nrrd", head + "type: ushort\n\n" + shorts), bytes);
  EXPECT_THAT(warnings_, Contains("its colours go up to 249, and are taken as bytes, though the type is "
                                  "uint16, little-endian"));
  const std::string floats = bytesOf<float>({1, 2, 3, 100, 200, 249});
  EXPECT_EQ(voxels("a.nrrd", head + "type: float\n\n" + floats), bytes);
  EXPECT_THAT(warnings_, Contains(HasSubstr("taken as bytes")));
  const std::string bright = bytesOf<float>({0, 0.2f, 1, 1.5f, 1, 0});
  EXPECT_EQ(voxels("a.nrrd", head + "type: float\n\n" + bright),
            (Voxels{{0, rgba(0, 51, 255)}, {1, rgba(255, 255, 0)}}));
  EXPECT_THAT(warnings_, Contains("its colours go up to 1.5, and those above 1 are taken as 1"));
  const std::string wide = bytesOf<std::uint16_t>({0, 0, 65535, 257, 514, 0});
  const Voxels wideWords{{0, rgba(0, 0, 255)}, {1, rgba(1, 2, 0)}};
  EXPECT_EQ(voxels("a.nrrd", head + "type: ushort\n\n" + wide), wideWords);
  EXPECT_TRUE(warnings_.empty());
  const std::string wider = bytesOf<std::int32_t>({0, 0, 65535, 257, 514, 0});
  EXPECT_EQ(voxels("a.nrrd", head + "type: int\n\n" + wider), wideWords);
  EXPECT_THAT(warnings_, Contains(HasSubstr("up to 65535, and are taken as numbers of 16 bits")));
  // Means of bytes are not whole, and what is no number says nothing.
  const float nan = std::nanf("");
  const std::string means = bytesOf<float>({1.4f, 2, 3, 100, 200.5f, nan});
  EXPECT_EQ(voxels("a.nrrd", head + "type: float\n\n" + means),
            (Voxels{{0, rgba(1, 2, 3)}, {1, rgba(100, 201, 0)}}));
  const std::string dark = bytesOf<std::uint16_t>({0, 0, 4095, 257, 514, 0});
  voxels("a.nrrd", head + "type: ushort\n\n" + dark);
  EXPECT_THAT(warnings_, Contains("its colours go up to 4095 of 65535, and are nearly black"));
}

TEST_F(DenseVolumes, AlphaIsAShareOrAByte) {
  const std::string head = "NRRD0004\ndimension: 4\nsizes: 4 2 1 1\nencoding: raw\nendian: little\n"
                           "kinds: RGBA-color domain domain domain\ntype: float\n\n";
  EXPECT_EQ(voxels("a.nrrd", head + bytesOf<float>({10, 20, 30, 1, 250, 2, 3, 0.2f})),
            (Voxels{{0, rgba(10, 20, 30, 255)}, {1, rgba(250, 2, 3, 51)}}));
  EXPECT_EQ(voxels("a.nrrd", head + bytesOf<float>({10, 20, 30, 255, 250, 2, 3, 51})),
            (Voxels{{0, rgba(10, 20, 30, 255)}, {1, rgba(250, 2, 3, 51)}}));
}

TEST_F(DenseVolumes, NrrdAttachedAndDetachedRawAndCompressed) {
  const std::string six = "\1\2\3\4\5\6";
  EXPECT_EQ(voxels("a.nrrd", nrrdOfBytes("encoding: raw\n")), kSix);
  EXPECT_EQ(voxels("a.NRRD", nrrdOfBytes("encoding: raw\r\nkey:=value: x\n", six + "more")), kSix);
  EXPECT_EQ(voxels("a.nrrd", nrrdOfBytes("encoding: gzip\n", gzipped(six))), kSix);
  EXPECT_EQ(voxels("a.nrrd", nrrdOfBytes("encoding: gz\nbyte skip: 2\n", gzipped("ab" + six))), kSix);
  EXPECT_EQ(voxels("a.nrrd", nrrdOfBytes("encoding: gz\n", gzipped("\1\2") + gzipped("\3\4\5\6"))), kSix);
  EXPECT_EQ(voxels("a.nrrd", nrrdOfBytes("encoding: raw\nbyte skip: -1\n", "xyz" + six)), kSix);
  EXPECT_EQ(voxels("a.nrrd", nrrdOfBytes("encoding: raw\nlineskip: 2\nbyteskip: 1\n", "one\ntwo\nx" + six)),
            kSix);
  folder_.file("a.bin", six);
  EXPECT_EQ(voxels("a.nhdr", nrrdOfBytes("encoding: raw\ndata file: a.bin\n", "")), kSix);
  folder_.file("a.bin.gz", gzipped(six));
  EXPECT_EQ(voxels("a.nhdr", nrrdOfBytes("encoding: gzip\ndatafile: a.bin.gz", "")), kSix);
}

TEST_F(DenseVolumes, NrrdSaysWhereItsSamplesLie) {
  voxels("a.nrrd", nrrdOfBytes("encoding: raw\nspacings: 2 3 4\n"));
  EXPECT_THAT(toModel(1, 1, 1), ElementsAre(2, 3, 4));
  voxels(
      "a.nrrd",
      nrrdOfBytes("encoding: raw\nspace directions: (0,2,0) (-1,0,0) (0,0,1)\nspace origin: (10, 20, 30)\n"));
  EXPECT_THAT(toModel(0.5, 0.5, 0.5), ElementsAre(10, 20, 30));
  EXPECT_THAT(toModel(1.5, 0.5, 0.5), ElementsAre(10, 22, 30));
  EXPECT_THAT(toModel(0.5, 1.5, 0.5), ElementsAre(9, 20, 30));
}

TEST_F(DenseVolumes, SamplesAreKeptAsTheyAre) {
  options_.keepsSamples = true;
  const auto words = [&](const char *type, const std::string &bytes) {
    const auto input =
        openInput("raw:4x1x1:" + std::string(type) + ":" + folder_.file("samples.raw", bytes), options_);
    EXPECT_TRUE(input) << input.error().message;
    std::vector<std::uint32_t> read(4);
    for (const auto &[place, word] : voxelsOf(*input->source))
      read[static_cast<std::size_t>(mortonCell(place).x)] = word;
    return read;
  };
  const auto int32 = [](std::int32_t value) { return static_cast<std::uint32_t>(value); };
  EXPECT_THAT(words("int16le", bytesOf<std::int16_t>({-1024, 0, 3071, -1})),
              ElementsAre(int32(-1024), 0u, 3071u, int32(-1)));
  EXPECT_THAT(words("float32le", bytesOf<float>({-0.5f, 0, 1e20f, 70000})),
              ElementsAre(std::bit_cast<std::uint32_t>(-0.5f), 0u, std::bit_cast<std::uint32_t>(1e20f),
                          std::bit_cast<std::uint32_t>(70000.0f)));
  const auto large = openInput("raw:4x1x1:uint32le:" +
                                   folder_.file("samples.raw", bytesOf<std::uint32_t>({0, 1, 0xffffffff, 2})),
                               options_);
  ASSERT_FALSE(large);
  EXPECT_THAT(large.error().message, HasSubstr("from 0 to 4294967295, and 4 bytes hold whole numbers"));
}

TEST_F(DenseVolumes, BinvoxRunsGoAlongYThenZThenX) {
  // 2 x 3 x 4 cells in the order x, z, y: a run of 5 empty ones, 2 full ones, 17 empty ones.
  const std::string file =
      "#binvox 1\ndim 2 3 4\ntranslate 1 2 3\nscale 8\ndata\n" + std::string("\0\5\1\2\0\21", 6);
  EXPECT_EQ(voxels("a.binvox", file),
            (Voxels{{mortonCode({0, 1, 1}), kWhite}, {mortonCode({0, 2, 1}), kWhite}}));
  EXPECT_EQ(extent_, (Int3{2, 4, 3}));
  EXPECT_THAT(toModel(1, 1, 1), ElementsAre(3, 4, 5));
  EXPECT_EQ(provenance_, "coverage=voxels up=y");
  options_.zUp = true;
  EXPECT_EQ(voxels("a.binvox", file),
            (Voxels{{mortonCode({0, 1, 2}), kWhite}, {mortonCode({0, 1, 1}), kWhite}}));
  EXPECT_EQ(extent_, (Int3{2, 3, 4}));
}

TEST_F(DenseVolumes, SharedVolumesAgree) {
  VOXC_SKIP_WITHOUT("volumes/fuel.nii.gz");
  const auto shared = [](const char *name) { return sharedModel("volumes/") + name; };
  const Voxels fuel = take(openInput("raw:64x33x32:uint8:" + shared("fuel_64x33x32_uint8.raw"), options_));
  EXPECT_EQ(fuel, take(openInput(shared("fuel.nii.gz"), options_)));
  EXPECT_EQ(fuel.size(), 13731u);
  EXPECT_FALSE(take(openInput(shared("test_128.binvox"), options_)).empty());
  EXPECT_EQ(extent_, (Int3{128, 128, 128}));
  options_.threshold = 40;
  EXPECT_FALSE(take(openInput(shared("bonsai.nii.gz"), options_)).empty());
  EXPECT_EQ(extent_, (Int3{256, 256, 256}));
}

} // namespace
} // namespace voxc
