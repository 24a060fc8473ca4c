// Ray files and hit files of both versions, and what is refused.
#include "common/RayFile.h"
#include "voxc/Trace/Face.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace voxc::tool {
namespace {

using ::testing::HasSubstr;

Expected<RayFile> parse(const std::string &text) {
  return parseRayFile(std::as_bytes(std::span(text)), "rays");
}

std::string problemOf(const std::string &text) {
  const auto file = parse(text);
  return file ? "" : file.error().message;
}

const std::vector<BoundedRay> kRays = {{{1, 2, 3}, 0.5f, {4, 5, 6}, 7},
                                       {{-1, 0, 0}, 0, {1, 0, 0}, std::numeric_limits<float>::infinity()}};

TEST(RayFile, OfVersion1IsRaysAlone) {
  const Ray rays[] = {{{1, 2, 3}, {4, 5, 6}}, {{7, 8, 9}, {1, 0, 0}}};
  const auto file = parse(std::string(reinterpret_cast<const char *>(rays), sizeof rays));
  ASSERT_TRUE(file);
  EXPECT_EQ(file->version(), 1);
  ASSERT_EQ(file->rays().size(), 2u);
  EXPECT_FALSE(file->rays().isBounded());
  EXPECT_EQ(file->rays()[1].origin[2], 9);
  EXPECT_EQ(file->rays().bounds(1), RayBounds{});
  EXPECT_TRUE(parse(""));
}

TEST(RayFile, OfVersion2ComesBack) {
  const auto file = parse(rayFileText(kRays));
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(file->version(), 2);
  ASSERT_EQ(file->rays().size(), 2u);
  EXPECT_EQ(file->rays().bytes().size(), 64u);
  EXPECT_EQ(std::memcmp(file->rays().bytes().data(), kRays.data(), 64), 0);
  EXPECT_EQ(file->rays().bounds(0), (RayBounds{0.5f, 7}));
  EXPECT_EQ(parse(rayFileText({}))->rays().isBounded(), true);
}

TEST(RayFile, IsRefusedWhereItIsBroken) {
  const std::string good = rayFileText(kRays);
  EXPECT_THAT(problemOf(std::string(23, 'x')), HasSubstr("multiple of 24"));
  EXPECT_THAT(problemOf(good.substr(0, 20)), HasSubstr("within its header"));
  EXPECT_THAT(problemOf(good.substr(0, good.size() - 1)), HasSubstr("should have 2 rays"));
  EXPECT_THAT(problemOf(good + std::string(32, '\0')), HasSubstr("should have 2 rays"));
  const auto with = [&](std::size_t at, char byte) {
    std::string text = good;
    text[at] = byte;
    return problemOf(text);
  };
  EXPECT_THAT(with(8, 3), HasSubstr("version 3"));
  EXPECT_THAT(with(12, 24), HasSubstr("24 bytes each"));
  EXPECT_THAT(with(23, '\x7f'),
              HasSubstr("should have 9151314442816847874 rays")); // Nobody makes room for them.
  EXPECT_THAT(problemOf(hitFileText({})), HasSubstr("is a hit file"));
}

TEST(HitFile, OfVersion2HasFacesAndNormals) {
  const Hit hits[] = {{{1, 2, 3}, 0xff112233, 4.5f, 3}, {{-1, -1, -1}, 0, 0, 0}, {{0, 0, 0}, 1, 0, kNoFace}};
  const std::uint32_t steps[] = {7, 8, 9};
  const std::string text = hitFileText(hits, steps);
  ASSERT_EQ(text.size(), 24u + 3 * 40u);
  EXPECT_EQ(text.substr(0, 8), "VOXCHITS");
  HitRecord records[3];
  std::memcpy(records, text.data() + 24, sizeof records);
  EXPECT_EQ(records[0].face, 3u);
  EXPECT_EQ(records[0].normal[1], 1.0f);
  EXPECT_EQ(records[0].steps, 7u);
  EXPECT_EQ(records[1].normal[0], 0.0f);
  EXPECT_EQ(records[2].normal[0], 0.0f);
  EXPECT_EQ(records[2].face, kNoFace);
}

TEST(Normal, PointsOutOfTheFace) {
  for (std::uint32_t face = 0; face < 6; ++face)
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(normalOf(face)[axis], axis == int(face / 2) ? (face % 2 == 0 ? -1.0f : 1.0f) : 0.0f);
  EXPECT_EQ(normalOf(kNoFace), glm::vec3(0));
  EXPECT_EQ(normalOf(~0u), glm::vec3(0));
}

} // namespace
} // namespace voxc::tool
