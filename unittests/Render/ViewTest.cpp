// Cameras by a word, and pictures of a volume, with the oracle in place of a kernel.
#include "voxc/Render/View.h"

#include "voxc/Oracle/Oracle.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace voxc {
namespace {

constexpr std::uint32_t kGrey = 0xff8090a0;

std::uint32_t wordOf(bool isFull) { return isFull ? kGrey : 0; }
std::uint32_t wordOf(std::uint32_t word) { return word; }

/// A volume of one raw grid, 16 voxels a side, whose voxels are those of which `isFull` says so, or of which
/// it tells the word.
template <typename IsFull> Volume volumeWhere(const IsFull &isFull) {
  constexpr int kSide = 16;
  std::vector<std::uint32_t> words = {1};
  VolumeInfo info;
  info.format = *parseFormat("R(4,4,4)");
  info.extent = {kSide, kSide, kSide};
  for (int z = 0; z < kSide; ++z)
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        words.push_back(wordOf(isFull(x, y, z)));
        info.voxels += words.back() != 0;
      }
  return Volume(std::move(info), std::move(words));
}

/// Traces by the oracle.
struct OracleTracer {
  explicit OracleTracer(const Volume &volume) : oracle(*Oracle::of(volume)) {}

  Expected<void> operator()(std::span<const Ray> rays, std::span<Hit> hits, const TraceOptions &) {
    count += rays.size();
    for (std::size_t i = 0; i < rays.size(); ++i)
      hits[i] = oracle.trace(rays[i]);
    return {};
  }

  Oracle oracle;
  std::size_t count = 0;
};

TEST(Frame, TouchesTheEdgesAboveAndBelow) {
  Camera camera;
  camera.eye = {3, 4, 5};
  camera.look = {0, 0, 0};
  camera.width = 200;
  camera.height = 100;
  const std::vector<glm::dvec3> points = {{0, 0, 0}, {9, 1, 2}, {-4, 7, 1}, {2, -3, 8}};
  const Camera framed = frame(camera, points);
  const glm::dvec3 front = glm::normalize(framed.look - framed.eye);
  const glm::dvec3 right = glm::normalize(glm::cross(front, framed.up)), up = glm::cross(right, front);
  const double tangent = std::tan(glm::radians(framed.verticalFov / 2));
  double left = 1, most = -1, low = 1, high = -1;
  for (const glm::dvec3 &point : points) {
    const glm::dvec3 to = point - framed.eye;
    const double depth = glm::dot(to, front);
    EXPECT_GT(depth, 0);
    left = std::min(left, glm::dot(to, right) / depth / (2 * tangent));
    most = std::max(most, glm::dot(to, right) / depth / (2 * tangent));
    low = std::min(low, glm::dot(to, up) / depth / tangent);
    high = std::max(high, glm::dot(to, up) / depth / tangent);
  }
  // What decides is the height here; in width there is room.
  EXPECT_NEAR(low, -0.92, 1e-6);
  EXPECT_NEAR(high, 0.92, 1e-6);
  EXPECT_GT(left, -0.92);
  EXPECT_LT(most, 0.92);
}

TEST(Frame, LeavesOutWhatStandsApartAndKeepsAPeak) {
  Camera camera;
  camera.eye = {0, 0, 9};
  camera.width = camera.height = 100;
  std::vector<glm::dvec3> points;
  for (int i = 0; i <= 1000; ++i)
    points.emplace_back(i % 100, i / 100, 0);
  const double without = frame(camera, points).eye.z;
  // Higher and higher, but without a gap.
  for (int i = 0; i < 27; ++i)
    points.emplace_back(50, 10 + 3 * i, 0);
  const glm::dvec3 peaked = frame(camera, points).eye;
  EXPECT_GT(peaked.y, 30);
  points.resize(1001);
  points.emplace_back(50, 900, 0);
  EXPECT_NEAR(frame(camera, points).eye.z, without, 1e-9);
}

constexpr View kOutside[] = {View::Iso,   View::Front, View::Back,  View::Left,
                             View::Right, View::Top,   View::Bottom};

/// The hits of a camera's picture.
std::vector<Hit> pictureOf(const Camera &camera, OracleTracer &tracer) {
  std::vector<Hit> hits(std::size_t(camera.width) * std::size_t(camera.height));
  EXPECT_TRUE(tracer(cameraRays(camera), hits, {}));
  return hits;
}

/// The least distance of what is seen from an edge of the picture, in pixels.
int leastMargin(const Camera &camera, std::span<const Hit> hits) {
  int margin = camera.width;
  for (int row = 0; row < camera.height; ++row)
    for (int column = 0; column < camera.width; ++column)
      if (hits[std::size_t(row * camera.width + column)].isHit())
        margin = std::min({margin, row, column, camera.height - 1 - row, camera.width - 1 - column});
  return margin;
}

TEST(ViewCamera, FillsTheFrameFromOutside) {
  const Volume volume = volumeWhere([](int x, int y, int z) { return x < 3 && y < 3 && z < 3; });
  OracleTracer tracer(volume);
  for (const View view : {View::Auto, View::Iso, View::Front, View::Top}) {
    const std::vector<Hit> hits = pictureOf(*viewCamera(view, volume, tracer, 40, 40), tracer);
    EXPECT_GT(std::ranges::count_if(hits, &Hit::isHit), 600) << toString(view);
  }
}

TEST(ViewCamera, TakesFewRaysForAPictureOfAnyShape) {
  const Volume volume = volumeWhere([](int x, int y, int z) { return x < 3 && y < 3 && z < 3; });
  OracleTracer tracer(volume);
  for (const auto &[width, height] : {std::pair(1, 32768), std::pair(32768, 1), std::pair(300, 400)}) {
    tracer.count = 0;
    ASSERT_TRUE(viewCamera(View::Front, volume, tracer, width, height));
    EXPECT_LT(tracer.count, 400'000u) << width << "x" << height;
  }
}

TEST(ViewCamera, HasSmallThingsWithinTheFrame) {
  // A body with horns and a tail, of which the ends are a hundredth of what is seen or less.
  const Volume volume = volumeWhere([](int x, int y, int z) {
    const bool isBody = x > 3 && x < 12 && y < 10 && z > 4 && z < 11;
    const bool isHorn = (x == 4 || x == 11) && y < 16 && z == 7;
    return isBody || isHorn || (x == 7 && y == 2);
  });
  OracleTracer tracer(volume);
  for (const View view : kOutside)
    for (const double height : {0.0, 1.0}) {
      const Camera like{.verticalFov = 0, .width = 320, .height = 180, .orthographicHeight = height};
      const FoundView found = *findView(view, volume, tracer, like);
      const int margin = leastMargin(found.camera, pictureOf(found.camera, tracer));
      EXPECT_EQ(found.view, view);
      EXPECT_EQ(found.camera.isOrthographic(), height > 0);
      // A hundredth of the frame at least, and it touches the margin of four hundredths somewhere.
      EXPECT_GE(margin, 4) << toString(view) << height;
      EXPECT_LE(margin, 14) << toString(view) << height;
    }
}

TEST(ViewCamera, SeesSpacingAsItIs) {
  // A plate of 15 x 15 x 5 voxels of 1 x 1 x 3 is a cube.
  const Volume volume = volumeWhere([](int x, int y, int z) { return x < 15 && y < 15 && z < 5; });
  OracleTracer tracer(volume);
  for (const View view : {View::Front, View::Right, View::Top}) {
    const Camera like{
        .verticalFov = 0, .width = 200, .height = 200, .spacing = {1, 1, 3}, .orthographicHeight = 1};
    const Camera camera = findView(view, volume, tracer, like)->camera;
    const std::vector<Hit> hits = pictureOf(camera, tracer);
    // All but the margins of four hundredths on each side.
    EXPECT_NEAR(double(std::ranges::count_if(hits, &Hit::isHit)), 0.92 * 0.92 * 200 * 200, 800)
        << toString(view);
    EXPECT_NEAR(camera.orthographicHeight, 15 / 0.92, 0.1);
  }
}

/// A yard with walls around, a roof over all but the middle, and columns that carry it; of several colours.
std::uint32_t yard(int x, int y, int z) {
  constexpr std::uint32_t kRed = 0xff2020c0, kSand = 0xff80c0e0, kGreen = 0xff40a040;
  if (y == 0)
    return kSand;
  if (x == 0 || z == 0 || x == 15 || z == 15)
    return y < 8 ? kGrey : kGreen;
  if ((x == 4 || x == 11) && (z == 4 || z == 8 || z == 11))
    return kRed;
  return y == 15 && (x < 5 || x > 10 || z < 5 || z > 10) ? kSand : 0;
}

TEST(ViewCamera, StandsInsideOfAYardWithEaves) {
  const Volume volume = volumeWhere(yard);
  OracleTracer tracer(volume);
  for (const View view : {View::Auto, View::Inside}) {
    const Camera camera = *viewCamera(view, volume, tracer, 40, 40);
    EXPECT_TRUE(camera.eye.x > 1 && camera.eye.x < 15 && camera.eye.z > 1 && camera.eye.z < 15);
  }
  EXPECT_EQ(findView(View::Auto, volume, tracer, {.verticalFov = 0})->view, View::Inside);
}

TEST(ViewCamera, StandsOutsideOfAHollow) {
  // Walls all around, a hole in the roof, and nothing within: a pot.
  const Volume volume = volumeWhere([](int x, int y, int z) {
    const double dx = x - 7.5, dy = y - 7.5, dz = z - 7.5;
    const double square = dx * dx + dy * dy + dz * dz;
    return square < 60 && square > 40 && !(y > 10 && dx * dx + dz * dz < 10);
  });
  OracleTracer tracer(volume);
  EXPECT_EQ(findView(View::Auto, volume, tracer, {.verticalFov = 0})->view, View::Iso);
}

TEST(ViewCamera, IsNeverInsideIfOrthographic) {
  const Volume volume = volumeWhere(yard);
  OracleTracer tracer(volume);
  const Camera like{.verticalFov = 0, .orthographicHeight = 1};
  EXPECT_EQ(findView(View::Auto, volume, tracer, like)->view, View::Iso);
  EXPECT_FALSE(findView(View::Inside, volume, tracer, like));
}

TEST(ViewCamera, OfNothingIsAnError) {
  const Volume volume = volumeWhere([](int, int, int) { return false; });
  OracleTracer tracer(volume);
  EXPECT_FALSE(viewCamera(View::Auto, volume, tracer, 40, 40));
}

TEST(Render, ThreadsAndBandsChangeNothing) {
  const Volume volume = volumeWhere([](int x, int y, int z) { return (x * y + z) % 7 == 0; });
  OracleTracer tracer(volume);
  const Camera camera = frameExtent({16, 16, 16}, 24, 18);
  RenderOptions options{.isSmooth = true, .threads = 1};
  const Rendering one = *render(volume, camera, {tracer, tracer}, options);
  options.threads = 3;
  const Rendering three = *render(volume, camera, {tracer, tracer}, options);
  EXPECT_EQ(one.picture.pixels, three.picture.pixels);
  EXPECT_EQ(one.light, three.light);
}

TEST(Render, ASunlitFloorIsBrighterThanItsShadow) {
  // A floor, and a roof over a part of it, which the sun right above does not see.
  const Volume volume = volumeWhere([](int x, int y, int) { return y == 0 || (y == 12 && x < 8); });
  OracleTracer tracer(volume);
  Camera camera;
  camera.eye = {8, 10, 8};
  camera.look = {8, 0, 8.01};
  camera.up = {0, 0, -1};
  camera.verticalFov = 60;
  camera.width = camera.height = 16;
  const RenderOptions options{.samples = 4, .sun = {0, 1, 0}};
  const Rendering picture = *render(volume, camera, {tracer, tracer}, options);
  const auto brightness = [&](int column) { return picture.light[std::size_t(4 * (8 * 16 + column))]; };
  EXPECT_GT(brightness(13), 2 * brightness(2));
  EXPECT_NEAR(picture.nearest, 9, 0.2);
}

TEST(Render, LightGoesThroughSpacedSpace) {
  // A staircase of 45 degrees in spaced space, whose voxels are flat: its smooth normal is diagonal, and the
  // sun that stands right above it lights it by the cosine.
  const Volume volume = volumeWhere([](int x, int y, int) { return y <= 2 * x && y > 2 * x - 6; });
  OracleTracer tracer(volume);
  const Camera camera{
      .eye = {-4, 20, 8}, .look = {4, 8, 8}, .verticalFov = 8, .width = 9, .height = 9, .spacing = {2, 1, 1}};
  const Rendering picture =
      *render(volume, camera, {tracer, tracer}, {.style = Style::Normals, .samples = 1, .isSmooth = true});
  const float *const middle = &picture.light[4 * (4 * 9 + 4)];
  ASSERT_EQ(middle[3], 1);
  // Normals are shown as 0.5 + n / 2 on the screen: -x and +y are alike far from the middle.
  const float left = 0.5f - std::pow(middle[0], 1 / 2.4f), up = std::pow(middle[1], 1 / 2.4f) - 0.5f;
  EXPECT_GT(left, 0.2f);
  EXPECT_NEAR(left, up, 0.08f);
}

TEST(Render, StylesTakeOnlyTheRaysThatTheyNeed) {
  const Volume volume = volumeWhere([](int, int y, int) { return y == 0; });
  OracleTracer eye(volume), light(volume);
  const Camera camera = frameExtent({16, 1, 16}, 16, 12);
  for (const StyleKind &kind : styleKinds()) {
    eye.count = light.count = 0;
    ASSERT_TRUE(render(volume, camera, {eye, light}, {.style = kind.style}));
    EXPECT_EQ(eye.count, 16u * 12 * kind.samples);
    EXPECT_EQ(light.count > 0, kind.isLit);
  }
}

} // namespace
} // namespace voxc
