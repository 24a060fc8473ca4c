// Pictures of hits that are known.
#include "voxc/Render/Picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace voxc {
namespace {

constexpr Hit kMiss = {{-1, -1, -1}, 0, 0, 0};
constexpr std::uint32_t kWhite = 0xffffffff;

/// A ray from outside through the middle of voxel (4, 4, 4), along one axis, and its hit.
struct Probe {
  Ray ray;
  Hit hit{{4, 4, 4}, kWhite, 4, 0};

  Probe(int axis, bool falling) {
    std::ranges::fill(ray.origin, 4.5f);
    std::ranges::fill(ray.direction, 0.0f);
    ray.origin[axis] = falling ? 9.0f : 0.0f;
    ray.direction[axis] = falling ? -1.0f : 1.0f;
  }
};

std::uint32_t shadeOne(const Ray &ray, const Hit &hit) {
  return shade({&ray, 1}, {&hit, 1}, 1, 1).pixels.front();
}

TEST(Shade, TellsTheSixFacesApart) {
  std::set<std::uint32_t> pixels;
  for (int axis = 0; axis < 3; ++axis)
    for (bool falling : {false, true}) {
      Probe probe(axis, falling);
      pixels.insert(shadeOne(probe.ray, probe.hit));
    }
  EXPECT_EQ(pixels.size(), 6u);
}

TEST(Shade, TopsAreBrightest) {
  Probe top(1, true);
  EXPECT_EQ(shadeOne(top.ray, top.hit), kWhite);
}

TEST(Shade, TakesTheFaceThatWasEnteredLast) {
  // Into voxel (4, 4, 4): x is entered at t = 4, y at t = 3.
  Probe probe(0, false);
  probe.ray.origin[1] = 1;
  probe.ray.direction[1] = 1;
  Probe alongX(0, false);
  EXPECT_EQ(shadeOne(probe.ray, probe.hit), shadeOne(alongX.ray, alongX.hit));
}

TEST(Shade, KeepsTheColourAndMakesItOpaque) {
  Probe probe(1, true);
  probe.hit.rgba = 0x00336699;
  EXPECT_EQ(shadeOne(probe.ray, probe.hit), 0xff336699u);
}

TEST(Shade, SkyIsOpaqueAndChangesWithHeight) {
  Ray up{{0, 0, 0}, {0, 1, 0}};
  Ray ahead{{0, 0, 0}, {0, 0, 5}};
  EXPECT_NE(shadeOne(up, kMiss), shadeOne(ahead, kMiss));
  EXPECT_EQ(shadeOne(up, kMiss) >> 24, 0xffu);
}

TEST(Shade, SurvivesRaysThatAreNone) {
  Ray still{{0, 0, 0}, {0, 0, 0}};
  EXPECT_EQ(shadeOne(still, kMiss) >> 24, 0xffu);
  EXPECT_EQ(shadeOne(still, Hit{{0, 0, 0}, kWhite, 0, 0}), kWhite);
}

std::vector<Hit> hitsWithSteps(int count, std::uint32_t low, std::uint32_t high) {
  std::vector<Hit> hits(static_cast<std::size_t>(count), kMiss);
  for (std::size_t i = 0; i < hits.size(); ++i)
    hits[i].steps = i % 2 ? high : low;
  return hits;
}

TEST(Heatmap, ShowsMoreStepsBrighter) {
  auto picture = heatmap(hitsWithSteps(2, 3, 300), 2, 1);
  auto green = [](std::uint32_t pixel) { return pixel >> 8 & 0xff; };
  EXPECT_LT(green(picture.pixels[0]), green(picture.pixels[1]));
}

TEST(Heatmap, OfEqualStepsHasOneColour) {
  auto picture = heatmap(hitsWithSteps(4, 7, 7), 2, 2);
  EXPECT_EQ(std::ranges::count(picture.pixels, picture.pixels.front()), 4);
}

TEST(Heatmap, LegendShowsItsNumbers) {
  // The same map of colours, but for the largest number.
  auto few = heatmap(hitsWithSteps(320 * 240, 0, 10), 320, 240);
  auto many = heatmap(hitsWithSteps(320 * 240, 0, 70), 320, 240);
  auto inked = [](const Picture &picture) { return std::ranges::count(picture.pixels, kWhite); };
  EXPECT_GT(inked(few), 0);
  EXPECT_NE(few.pixels, many.pixels);
  // Above the legend nothing differs.
  EXPECT_TRUE(std::equal(few.pixels.begin(), few.pixels.begin() + 320 * 200, many.pixels.begin()));
}

TEST(Heatmap, TinyPicturesHaveNoLegend) {
  auto picture = heatmap(hitsWithSteps(16, 1, 1), 4, 4);
  EXPECT_EQ(std::ranges::count(picture.pixels, picture.pixels.front()), 16);
}

TEST(Heatmap, LargestStepCountsFit) {
  EXPECT_EQ(heatmap(hitsWithSteps(320 * 240, 0, 0xffffffff), 320, 240).pixels.size(), 320u * 240u);
}

} // namespace
} // namespace voxc
