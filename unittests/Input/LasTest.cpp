// LAS files: every format of points, doubles, colours, intensities, and what is withheld or broken.
#include "Input/InputTesting.h"

#include "voxc/Input/Input.h"

#include <gmock/gmock.h>

#include <cstring>

namespace voxc {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::array<int, 11> kBytes{20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
constexpr std::array<int, 11> kColours{0, 0, 20, 28, 0, 28, 0, 30, 30, 0, 30};

template <typename Number> void put(std::string &bytes, std::size_t at, Number number) {
  std::memcpy(bytes.data() + at, &number, sizeof number);
}

struct LasPoint {
  std::array<std::int32_t, 3> place{};
  std::uint16_t intensity = 0;
  std::array<std::uint16_t, 3> colour{};
  bool isWithheld = false;
};

/// A file of version 1.`minor`, whose points have `more` bytes behind those of their format.
std::string las(int minor, int format, const std::vector<LasPoint> &points,
                const std::array<double, 3> &scale, const std::array<double, 3> &offset, int more = 0) {
  const std::size_t head = minor == 4 ? 375 : minor == 3 ? 235 : 227;
  const auto stride = static_cast<std::size_t>(kBytes[static_cast<std::size_t>(format)] + more);
  std::string bytes(head + points.size() * stride, '\0');
  bytes.replace(0, 4, "LASF");
  bytes[24] = 1;
  bytes[25] = static_cast<char>(minor);
  put(bytes, 94, static_cast<std::uint16_t>(head));
  put(bytes, 96, static_cast<std::uint32_t>(head));
  bytes[104] = static_cast<char>(format);
  put(bytes, 105, static_cast<std::uint16_t>(stride));
  // The old count is 0 where formats are new.
  put(bytes, 107, static_cast<std::uint32_t>(format < 6 ? points.size() : 0));
  if (minor == 4)
    put(bytes, 247, static_cast<std::uint64_t>(points.size()));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    put(bytes, 131 + 8 * axis, scale[axis]);
    put(bytes, 155 + 8 * axis, offset[axis]);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t at = head + i * stride;
    for (std::size_t axis = 0; axis < 3; ++axis)
      put(bytes, at + 4 * axis, points[i].place[axis]);
    put(bytes, at + 12, points[i].intensity);
    if (points[i].isWithheld)
      bytes[at + 15] = static_cast<char>(format < 6 ? 0x80 : 0x04);
    const auto colour = static_cast<std::size_t>(kColours[static_cast<std::size_t>(format)]);
    for (std::size_t channel = 0; channel < 3 && colour > 0; ++channel)
      put(bytes, at + colour + 2 * channel, points[i].colour[channel]);
  }
  return bytes;
}

class Las : public OpenedInputs {
protected:
  Las() { options_.voxelSize = {1, 0}; }
};

const std::array<double, 3> kOne{1, 1, 1};

TEST_F(Las, PointsOfEveryFormatAreVoxels) {
  const std::vector<LasPoint> points{{{0, 0, 0}, 10, {65535, 0, 32768}}, {{4, 2, 1}, 20, {257, 514, 771}}};
  for (int format = 0; format <= 10; ++format)
    for (const int more : {0, 3}) {
      const bool hasColours = kColours[static_cast<std::size_t>(format)] > 0;
      const Voxels expected{{mortonCode({0, 0, 0}), hasColours ? rgba(255, 0, 128) : rgba(0, 0, 0)},
                            {mortonCode({3, 1, 0}), hasColours ? rgba(1, 2, 3) : rgba(255, 255, 255)}};
      const std::string file = las(format < 6 ? 2 : 4, format, points, kOne, {0, 0, 0}, more);
      EXPECT_EQ(voxels("a.las", file), expected) << format;
      EXPECT_THAT(warnings_,
                  ElementsAre(HasSubstr("what else its points have is left out: returns, classes")));
      EXPECT_EQ(warnings_[0].find("3 bytes of their own") != std::string::npos, more == 3);
      for (std::size_t size = 0; size < file.size(); size += 31)
        EXPECT_NE(problem("b.las", file.substr(0, size)), "none");
    }
}

TEST_F(Las, CoordinatesStayDoubles) {
  // Places of a map, of which float32 has none within half a metre.
  const std::vector<LasPoint> points{{{0, 0, 0}}, {{250, 0, 0}}, {{999, 500, 0}}};
  options_.voxelSize = {0.25, 0};
  EXPECT_EQ(voxels("a.las", las(2, 0, points, {0.001, 0.001, 0.001}, {33500000.125, 5800000.5, 0})),
            (Voxels{{mortonCode({0, 0, 0}), 0xffffffff},
                    {mortonCode({1, 0, 0}), 0xffffffff},
                    {mortonCode({3, 1, 0}), 0xffffffff}}));
  EXPECT_EQ(map_ * glm::dvec4(0, 0, 0, 1), glm::dvec3(33500000.125, 5800000.5, 0));
}

TEST_F(Las, HeightIsUpUnlessSomebodySays) {
  const std::vector<LasPoint> points{{{0, 0, 0}}, {{1, 2, 5}}};
  const std::string file = las(2, 0, points, kOne, {0, 0, 0});
  options_.isAutomatic = true;
  voxels("a.las", file);
  EXPECT_EQ(extent_, (Int3{1, 5, 2}));
  options_.isUpKnown = true;
  voxels("a.las", file);
  EXPECT_EQ(extent_, (Int3{1, 2, 5}));
}

TEST_F(Las, BytesInPlaceOfShortsAreColours) {
  const std::vector<LasPoint> points{{{0, 0, 0}, 0, {255, 0, 128}}, {{2, 0, 0}, 0, {1, 2, 3}}};
  EXPECT_EQ(voxels("a.las", las(2, 2, points, kOne, {0, 0, 0})),
            (Voxels{{mortonCode({0, 0, 0}), rgba(255, 0, 128)}, {mortonCode({1, 0, 0}), rgba(1, 2, 3)}}));
  EXPECT_THAT(warnings_,
              Contains("its colours are at most 255, and are taken as bytes, though the format has 16 bits"));
}

TEST_F(Las, GreysGoFromTheLeastIntensityToTheBrightButOneInAHundred) {
  std::vector<LasPoint> points;
  for (std::int32_t i = 0; i < 200; ++i)
    points.push_back({{i, 0, 0}, static_cast<std::uint16_t>(i == 199 ? 65535 : i == 0 ? 100 : 200)});
  const Voxels found = voxels("a.las", las(2, 0, points, kOne, {0, 0, 0}));
  EXPECT_EQ(found.at(mortonCode({0, 0, 0})), rgba(0, 0, 0));
  EXPECT_EQ(found.at(mortonCode({100, 0, 0})), rgba(255, 255, 255));
}

TEST_F(Las, WhatIsWithheldIsNoPoint) {
  for (const int format : {0, 6}) {
    const std::vector<LasPoint> points{{{0, 0, 0}}, {{3, 0, 0}, 0, {}, true}, {{2, 0, 0}}};
    EXPECT_EQ(voxels("a.las", las(4, format, points, kOne, {0, 0, 0})).size(), 2u);
    EXPECT_EQ(extent_, (Int3{2, 1, 1}));
    EXPECT_THAT(warnings_, Contains("1 point is left out, withheld as the file says"));
  }
}

TEST_F(Las, BytesBehindThePointsAreTold) {
  const std::string file = las(2, 0, {{{0, 0, 0}}, {{1, 1, 1}}}, kOne, {0, 0, 0});
  voxels("a.las", file + "123");
  EXPECT_THAT(warnings_, Contains("3 bytes are left out, which lie behind the 2 points that its head says"));
  voxels("a.las", las(2, 4, {{{0, 0, 0}}, {{1, 1, 1}}}, kOne, {0, 0, 0}) + "waves");
  EXPECT_THAT(warnings_, testing::Not(Contains(HasSubstr("lie behind"))));
}

TEST_F(Las, WhatIsNotReadIsRefused) {
  const std::string file = las(2, 0, {{{0, 0, 0}}, {{1, 1, 1}}}, kOne, {0, 0, 0});
  const auto with = [&](std::size_t at, std::uint8_t byte) {
    std::string other = file;
    other[at] = static_cast<char>(byte);
    return other;
  };
  EXPECT_THAT(problem("a.las", with(104, 0x80)),
              HasSubstr("compressed by LASzip, which voxc does not read; save it"));
  std::string far = file;
  put(far, 131, 1e308);
  put(far, 227 + 20, 1000);
  EXPECT_THAT(problem("a.las", far), HasSubstr("point 1 has a coordinate that is not finite"));
  EXPECT_THAT(problem("a.las", with(104, 11)), HasSubstr("of the format 11 and have 20 bytes; voxc reads"));
  EXPECT_THAT(problem("a.las", with(105, 19)), HasSubstr("of the format 0 and have 19 bytes"));
  EXPECT_THAT(problem("a.las", with(25, 5)), HasSubstr("it is of version 1.5; voxc reads 1.0 to 1.4"));
  EXPECT_THAT(problem("a.las", with(110, 0x7f)), HasSubstr("but only 2 are there"));
  EXPECT_THAT(problem("a.las", with(0, 'X')), HasSubstr("does not begin with the head of a LAS file"));
  EXPECT_THAT(problem("a.las", las(2, 0, {{}}, {0, 1, 1}, {0, 0, 0})), HasSubstr("its scale is 0"));
  EXPECT_THAT(problem("a.las", las(2, 0, {{}}, kOne, {0, std::numeric_limits<double>::infinity(), 0})),
              HasSubstr("or its offset is none"));
  EXPECT_THAT(problem("a.laz", "x"),
              HasSubstr("points that LASzip compressed, which voxc does not read; save it as "
                        ".las or .ply, for example by CloudCompare"));
  EXPECT_THAT(problem("a.E57", "x"), HasSubstr("save it as .ply or .las"));
  EXPECT_THAT(problem("a.vtk", "x"), HasSubstr("save it as image data in XML (.vti)"));
  EXPECT_THAT(problem("a.xyzzy", "x"), testing::Not(HasSubstr(".laz")));
}

} // namespace
} // namespace voxc
