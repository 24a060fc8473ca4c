// Points of PLY files: encodings, indices and coordinates, colours, and files that lie.
#include "Source/SourceTesting.h"

#include "voxc/Input/Input.h"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstring>

namespace voxc {
namespace {

constexpr const char *kIndexProperties = "property int x\nproperty int y\nproperty int z\n"
                                         "property uchar red\nproperty uchar green\nproperty uchar blue\n";
constexpr const char *kFloatProperties = "property float x\nproperty float y\nproperty float z\n";

constexpr const char *kDoubleProperties = "property double x\nproperty double y\nproperty double z\n";

std::string header(const std::string &encoding, const std::string &count, const std::string &properties) {
  return "ply\nformat " + encoding + " 1.0\ncomment one vertex is not another vertex 99\nelement vertex " +
         count + "\n" + properties + "end_header\n";
}

template <typename Value> void append(std::string &bytes, Value value, bool bigEndian) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  if (bigEndian)
    std::reverse(raw, raw + sizeof value);
  bytes.append(raw, sizeof value);
}

class PlyPoints : public testing::Test {
protected:
  Expected<Input> open(const std::string &content) {
    return openInput(folder_.file("points.ply", content), options_);
  }
  Voxels voxels(const std::string &content) {
    auto input = open(content);
    EXPECT_TRUE(input) << input.error().message;
    return input ? voxelsOf(*input->source) : Voxels{};
  }
  std::string problem(const std::string &content) {
    auto input = open(content);
    return input ? "no error" : input.error().message;
  }

  TemporaryFolder folder_;
  InputOptions options_;
};

const Voxels kTwoVoxels{{mortonCode({3, 4, 5}), rgba(10, 20, 30)}, {mortonCode({0, 500, 1}), rgba(1, 2, 3)}};

TEST_F(PlyPoints, ReadsAscii) {
  EXPECT_EQ(voxels(header("ascii", "2", kIndexProperties) + "3 4 5 10 20 30\n0 500 1 1 2 3"), kTwoVoxels);
  EXPECT_EQ(voxels(header("ascii", "2", kIndexProperties) + "3 4 5 10 20 30\r\n+0 500 1 1 2 3\r\n"),
            kTwoVoxels);
}

TEST_F(PlyPoints, IntegersHaveAtMost32Bits) {
  const std::string properties = "property int x\nproperty int y\nproperty int z\nproperty uint rgba\n";
  const auto coloured = [&](const std::string &colour) {
    return header("ascii", "1", properties) + "1 2 3 " + colour + "\n";
  };
  for (const char *colour : {"4278256131", "-16711165"})
    EXPECT_EQ(voxels(coloured(colour)), (Voxels{{mortonCode({1, 2, 3}), rgba(1, 2, 3)}})) << colour;
  for (const char *colour : {"4294967296", "-2147483649", "1e20", "inf", "nan", "0.5"}) {
    auto input = open(coloured(colour));
    ASSERT_FALSE(input) << colour;
    EXPECT_NE(input.error().message.find("row 0 of 'vertex'"), std::string::npos) << input.error().message;
  }
}

TEST_F(PlyPoints, ReadsBothByteOrders) {
  for (const bool big : {false, true}) {
    std::string bytes = header(big ? "binary_big_endian" : "binary_little_endian", "2", kIndexProperties);
    for (const int value : {3, 4, 5})
      append(bytes, value, big);
    bytes += {10, 20, 30};
    for (const int value : {0, 500, 1})
      append(bytes, value, big);
    bytes += {1, 2, 3};
    EXPECT_EQ(voxels(bytes), kTwoVoxels) << big;
  }
}

TEST_F(PlyPoints, ReadsEveryTypeOfProperty) {
  std::string bytes = header("binary_big_endian", "1",
                             "property double weight\nproperty list uchar short tags\nproperty short x\n"
                             "property uint8 y\nproperty uint32 z\nproperty float red\nproperty float green\n"
                             "property float blue\nproperty ushort alpha\n");
  append(bytes, 1.5, true);
  bytes.push_back(2);
  append(bytes, std::int16_t{-1}, true);
  append(bytes, std::int16_t{-2}, true);
  append(bytes, std::int16_t{300}, true);
  bytes.push_back(static_cast<char>(200));
  append(bytes, std::uint32_t{7}, true);
  for (const float channel : {1.0f, 0.0f, 0.5f})
    append(bytes, channel, true);
  append(bytes, std::uint16_t{0xffff}, true);
  EXPECT_EQ(voxels(bytes), (Voxels{{mortonCode({300, 200, 7}), rgba(255, 0, 128)}}));
}

TEST_F(PlyPoints, FirstOfDuplicatesWinsAndWordZeroIsDropped) {
  const std::string properties = std::string(kIndexProperties) + "property uchar alpha\n";
  auto input = open(header("ascii", "5", properties) +
                    "1 1 1 0 0 0 0\n1 1 1 5 5 5 5\n2 0 0 0 0 0 0\n1 1 1 3 3 3 3\n1 1 1 8 8 8 8\n");
  ASSERT_TRUE(input);
  EXPECT_EQ(voxelsOf(*input->source), (Voxels{{mortonCode({1, 1, 1}), 0x05050505}}));
  ASSERT_EQ(input->warnings.size(), 1u);
  EXPECT_NE(input->warnings[0].find("2 points"), std::string::npos);
}

TEST_F(PlyPoints, ColoursCountToTheirLargest) {
  const std::string places = "property int x\nproperty int y\nproperty int z\n";
  const auto properties = [&](const std::string &type) {
    return places + "property " + type + " r\nproperty " + type + " g\nproperty " + type + " b\n";
  };
  const Voxels expected{{mortonCode({0, 0, 0}), rgba(200, 100, 1)}, {mortonCode({1, 0, 0}), rgba(255, 0, 0)}};
  for (const char *type : {"uchar", "ushort", "int", "float", "double"}) {
    EXPECT_EQ(voxels(header("ascii", "2", properties(type)) + "0 0 0 200 100 1\n1 0 0 255 0 0\n"), expected)
        << type;
    auto input = open(header("ascii", "2", properties(type)) + "0 0 0 200 100 1\n1 0 0 255 0 0\n");
    ASSERT_TRUE(input);
    EXPECT_EQ(input->warnings.size(), *type == 'i' || std::string_view(type) == "uchar" ? 0u : 1u) << type;
  }
  for (const bool big : {false, true}) {
    std::string bytes = header(big ? "binary_big_endian" : "binary_little_endian", "2", properties("ushort"));
    for (const int place : {0, 1}) {
      for (const int value : {place, 0, 0})
        append(bytes, value, big);
      for (const int value : {51400, 25700, 257})
        append(bytes, static_cast<std::uint16_t>(place == 0 ? value : value == 51400 ? 65535 : 0), big);
    }
    EXPECT_EQ(voxels(bytes), expected);
  }
}

TEST_F(PlyPoints, GaussianSplats) {
  const std::string properties =
      "property int x\nproperty int y\nproperty int z\nproperty float f_dc_0\nproperty float "
      "f_dc_1\nproperty float f_dc_2\nproperty float f_rest_0\nproperty float opacity\n"
      "property float scale_0\nproperty float rot_0\nproperty float more\n";
  // The harmonic is 0.2821: 1.7725 is half the way from grey to white, in logits -2.2 is an opacity of
  // 0.0998.
  auto input = open(header("ascii", "4", properties) + "0 0 0 0 1.772454 -1.772454 9 6 1 1 1\n" +
                    "1 0 0 9 -9 0.5 9 -2.1 1 1 1\n2 0 0 0 0 0 0 -2.2 1 1 1\n3 0 0 0 0 0 0 nan 1 1 1\n");
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(voxelsOf(*input->source),
            (Voxels{{mortonCode({0, 0, 0}), rgba(128, 255, 0)}, {mortonCode({1, 0, 0}), rgba(255, 0, 163)}}));
  ASSERT_EQ(input->warnings.size(), 3u);
  EXPECT_NE(input->warnings[0].find("left out are 2 of 4 splats, whose opacity is below 0.1"),
            std::string::npos);
  EXPECT_NE(input->warnings[1].find("higher harmonics are not used"), std::string::npos);
  EXPECT_NE(input->warnings[2].find("these properties are not used: more"), std::string::npos);
}

TEST_F(PlyPoints, NoColourIsWhite) {
  EXPECT_EQ(voxels(header("ascii", "1", "property int x\nproperty int y\nproperty int z\n") + "1 2 3\n"),
            (Voxels{{mortonCode({1, 2, 3}), 0xffffffff}}));
}

TEST_F(PlyPoints, CoordinatesFillTheResolution) {
  options_.resolution = 4;
  // 2 units are 4 voxels: the far corner belongs to the last voxel of its axis.
  EXPECT_EQ(voxels(header("ascii", "3", kFloatProperties) + "1 1 1\n3 2 1\n1.6 1.4 1\n"),
            (Voxels{{mortonCode({0, 0, 0}), 0xffffffff},
                    {mortonCode({3, 1, 0}), 0xffffffff},
                    {mortonCode({1, 0, 0}), 0xffffffff}}));
  auto input = open(header("ascii", "2", kFloatProperties) + "1 1 1\n3 2 1\n");
  ASSERT_TRUE(input);
  EXPECT_EQ(input->source->extent(), (Int3{4, 2, 1}));
  EXPECT_EQ(input->provenance, "resolution=4 coverage=points up=y");
}

TEST_F(PlyPoints, UpIsTurnedToY) {
  options_.resolution = 4;
  options_.zUp = true;
  EXPECT_EQ(voxels(header("ascii", "2", kFloatProperties) + "0 0 0\n4 0 2\n"),
            (Voxels{{mortonCode({0, 0, 0}), 0xffffffff}, {mortonCode({3, 1, 0}), 0xffffffff}}));
}

TEST_F(PlyPoints, BoundsCrop) {
  options_.resolution = 4;
  options_.bounds = {{0, 0, 0, 4, 4, 4}};
  EXPECT_EQ(voxels(header("ascii", "3", kFloatProperties) + "1 1 1\n5 1 1\n-0.1 1 1\n"),
            (Voxels{{mortonCode({1, 1, 1}), 0xffffffff}}));
}

/// A point of doubles, in text or as bytes.
std::string pointAt(double coordinate, bool isText) {
  char line[200];
  std::snprintf(line, sizeof line, "%.17g %.17g %.17g\n", coordinate, coordinate, coordinate);
  std::string bytes;
  for (int axis = 0; axis < 3; ++axis)
    append(bytes, coordinate, false);
  return isText ? line : bytes;
}

TEST_F(PlyPoints, PointsOnFacesOfTheirBoxHaveVoxels) {
  for (const bool isText : {false, true})
    for (int i = 0; i < 500; ++i) {
      const double low = 0.1 + i * 1.37 - 300, high = low + 0.01 + i * 0.07;
      options_.resolution = 2 + i;
      const Voxels found = voxels(header(isText ? "ascii" : "binary_little_endian", "2", kDoubleProperties) +
                                  pointAt(low, isText) + pointAt(high, isText));
      const Voxels expected{{mortonCode({0, 0, 0}), 0xffffffff},
                            {mortonCode({1 + i, 1 + i, 1 + i}), 0xffffffff}};
      EXPECT_EQ(found, expected) << isText << " " << low << " " << high;
    }
}

TEST_F(PlyPoints, BoundsThatPointsLieOnHoldThem) {
  options_.resolution = 49;
  options_.bounds = {{0.1, 0.1, 0.1, 0.8, 0.8, 0.8}};
  EXPECT_EQ(voxels(header("ascii", "4", kDoubleProperties) + "0.1 0.1 0.1\n0.8 0.8 0.8\n" +
                   "0.09999999999999999 0.5 0.5\n0.5 0.8000000000000002 0.5\n"),
            (Voxels{{mortonCode({0, 0, 0}), 0xffffffff}, {mortonCode({48, 48, 48}), 0xffffffff}}));
}

TEST_F(PlyPoints, CoordinatesOfMapsAreKept) {
  constexpr int kSide = 40;
  options_.resolution = kSide;
  // What is called float in a text has as many digits as what is called double.
  for (const char *properties : {kDoubleProperties, kFloatProperties}) {
    std::string text = header("ascii", std::to_string(kSide * kSide), properties);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        char line[100];
        std::snprintf(line, sizeof line, "%.2f %.2f 120.25\n", 500123.45 + x * 0.01, 5412345.65 + y * 0.01);
        text += line;
      }
    auto input = open(text);
    ASSERT_TRUE(input) << input.error().message;
    EXPECT_EQ(input->source->extent(), (Int3{kSide, kSide, 1}));
    EXPECT_EQ(voxelsOf(*input->source).size(), std::size_t{kSide * kSide});
  }
}

TEST_F(PlyPoints, IndexOutsideTheFormatIsAnError) {
  const std::string text = header("ascii", "1", kIndexProperties);
  EXPECT_NE(problem(text + "512 0 0 1 1 1\n").find("512, 0, 0"), std::string::npos);
  EXPECT_NE(
      problem(text + "0 -1 0 1 1 1\n").find("the voxel 0, -1, 0, but whole numbers are voxels from 0 on"),
      std::string::npos);
}

TEST_F(PlyPoints, OfPointsThatAreAllTransparentAlphaSaysNothing) {
  const std::string properties = std::string(kIndexProperties) + "property uchar alpha\n";
  const Voxels expected{{0, rgba(0, 0, 0)}, {1, rgba(1, 2, 3)}};
  auto input = open(header("ascii", "2", properties) + "0 0 0 0 0 0 0\n1 0 0 1 2 3 0\n");
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(voxelsOf(*input->source), expected);
  EXPECT_EQ(input->warnings,
            std::vector<std::string>{"all colours are wholly transparent, and are taken for opaque"});
  std::string bytes = header("binary_little_endian", "2", properties);
  for (const int x : {0, 1}) {
    for (const int coordinate : {x, 0, 0})
      append(bytes, coordinate, false);
    bytes += {static_cast<char>(x), static_cast<char>(2 * x), static_cast<char>(3 * x), 0};
  }
  EXPECT_EQ(voxels(bytes), expected);
}

TEST_F(PlyPoints, BytesBehindThemAreTold) {
  const std::vector<std::string> told{"6 bytes are left out, which lie behind the last element"};
  auto text = open(header("ascii", "1", kIndexProperties) + "3 4 5 10 20 30\n0 50 1\n");
  ASSERT_TRUE(text) << text.error().message;
  EXPECT_EQ(text->warnings, told);
  std::string bytes = header("binary_little_endian", "1", kIndexProperties);
  for (const int value : {3, 4, 5})
    append(bytes, value, false);
  auto binary = open(bytes + "abcdefghi");
  ASSERT_TRUE(binary) << binary.error().message;
  EXPECT_EQ(binary->warnings, told);
}

TEST_F(PlyPoints, NoPointsAreNoVoxels) {
  EXPECT_TRUE(voxels(header("ascii", "0", kIndexProperties)).empty());
  EXPECT_TRUE(voxels(header("ascii", "0", kFloatProperties)).empty());
}

TEST_F(PlyPoints, ClaimsAreCheckedAgainstTheFile) {
  for (const char *encoding : {"ascii", "binary_little_endian"})
    for (const char *count : {"3", "18446744073709551615", "4000000000"})
      EXPECT_NE(problem(header(encoding, count, kFloatProperties) + "0 0 0\n").find("claims"),
                std::string::npos);
  // Rows of nothing take no bytes: no file is large enough for them.
  EXPECT_NE(problem(header("ascii", "9999999999", "")).find("x, y and z"), std::string::npos);
  EXPECT_NE(
      problem(header("ascii", "1", kFloatProperties).replace(4, 0, "element none 999999999999\n") + "0 0 0")
          .find("claims"),
      std::string::npos);
}

TEST_F(PlyPoints, BrokenFilesAreErrors) {
  const std::string good = header("ascii", "1", kFloatProperties);
  const std::string list = header("ascii", "1", std::string("property list int int l\n") + kFloatProperties);
  for (const std::string &text :
       {std::string(), std::string("ply"), std::string("ply\n"), std::string("plx\nend_header\n"),
        std::string("ply\nend_header\n"), std::string("ply\nformat ascii 2.0\nend_header\n"),
        std::string("ply\nformat ascii 1.0\nproperty int x\nend_header\n"),
        std::string("ply\nformat ascii 1.0\nelement vertex -1\nend_header\n"),
        std::string("ply\nformat ascii 1.0\nelement vertex 1\nproperty long x\nend_header\n"),
        std::string("ply\nformat ascii 1.0\nelement vertex 1\nproperty list float int x\nend_header\n"),
        good + "0 zero 0\n", good + "0 0x1 0\n", good + "nan 0 0\n", good + "0 1e309 0\n", good + "0 0 inf\n",
        list + "-1 0 0 0\n", list + "999999999 0 0 0\n",
        header("ascii", "1", "property int x\nproperty int y\nproperty int z\n") + "1.5 0 0\n",
        header("ascii", "1", "property float x\nproperty float y\n") + "0 0\n"})
    EXPECT_NE(problem(text), "no error") << text;
}

} // namespace
} // namespace voxc
