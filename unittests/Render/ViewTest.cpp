// Cameras by a word, and pictures of a volume, with the oracle in place of a kernel.
#include "voxc/Render/View.h"

#include "voxc/Oracle/Oracle.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace voxc {
namespace {

/// A volume of one raw grid, 16 voxels a side, whose voxels are those of which `isFull` says so.
template <typename IsFull> Volume volumeWhere(const IsFull &isFull) {
  constexpr int kSide = 16;
  std::vector<std::uint32_t> words = {1};
  VolumeInfo info;
  info.format = *parseFormat("R(4,4,4)");
  info.extent = {kSide, kSide, kSide};
  for (int z = 0; z < kSide; ++z)
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        words.push_back(isFull(x, y, z) ? 0xff8090a0u : 0);
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

TEST(ViewCamera, FillsTheFrameFromOutside) {
  const Volume volume = volumeWhere([](int x, int y, int z) { return x < 3 && y < 3 && z < 3; });
  OracleTracer tracer(volume);
  for (const View view : {View::Auto, View::Iso, View::Front, View::Top}) {
    Camera camera = *viewCamera(view, volume, tracer, 40, 40);
    std::vector<Hit> hits(40 * 40);
    ASSERT_TRUE(tracer(cameraRays(camera), hits, {}));
    EXPECT_GT(std::ranges::count_if(hits, &Hit::isHit), 600) << toString(view);
  }
}

TEST(ViewCamera, StandsInsideOfAYardWithEaves) {
  // Walls around, and a roof over all but the middle.
  const Volume volume = volumeWhere([](int x, int y, int z) {
    const bool isWall = x == 0 || z == 0 || x == 15 || z == 15 || y == 0;
    return isWall || (y == 15 && (x < 5 || x > 10 || z < 5 || z > 10));
  });
  OracleTracer tracer(volume);
  for (const View view : {View::Auto, View::Inside}) {
    const Camera camera = *viewCamera(view, volume, tracer, 40, 40);
    EXPECT_TRUE(camera.eye.x > 1 && camera.eye.x < 15 && camera.eye.z > 1 && camera.eye.z < 15);
  }
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
