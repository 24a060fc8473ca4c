// Cameras: which way their rays go.
#include "voxc/Trace/Camera.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace voxc {
namespace {

void expectDirection(const Ray &ray, double x, double y, double z) {
  EXPECT_NEAR(ray.direction[0], x, 1e-6);
  EXPECT_NEAR(ray.direction[1], y, 1e-6);
  EXPECT_NEAR(ray.direction[2], z, 1e-6);
}

double length(const Ray &ray) { return std::hypot(ray.direction[0], ray.direction[1], ray.direction[2]); }

/// True if the line of a ray passes through the box of `extent` voxels.
bool meets(const Ray &ray, Int3 extent) {
  double enter = 0;
  double leave = INFINITY;
  for (int axis = 0; axis < 3; ++axis) {
    double a = (0 - ray.origin[axis]) / ray.direction[axis];
    double b = (extent[axis] - ray.origin[axis]) / ray.direction[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

TEST(CameraRays, MiddleOfOddPictureLooksAhead) {
  Camera camera{.eye = {1, 2, 3}, .look = {1, 2, -7}, .width = 5, .height = 3};
  auto rays = cameraRays(camera);
  ASSERT_EQ(rays.size(), 15u);
  expectDirection(rays[7], 0, 0, -1);
  EXPECT_EQ(rays[7].origin[1], 2);
}

TEST(CameraRays, RowsComeFromTheTopAndColumnsFromTheLeft) {
  // At 90 degrees the edges of a square picture lie at 45 degrees; the outer of two pixels halfway to them.
  Camera camera{.eye = {0, 0, 0}, .look = {0, 0, -1}, .verticalFov = 90, .width = 2, .height = 2};
  auto rays = cameraRays(camera);
  double unit = std::sqrt(0.25 + 0.25 + 1);
  expectDirection(rays[0], -0.5 / unit, 0.5 / unit, -1 / unit);
  expectDirection(rays[3], 0.5 / unit, -0.5 / unit, -1 / unit);
}

TEST(CameraRays, WidePicturesAreWiderNotTaller) {
  Camera camera{.eye = {0, 0, 0}, .look = {0, 0, -1}, .verticalFov = 90, .width = 4, .height = 1};
  auto rays = cameraRays(camera);
  double unit = std::sqrt(9 + 1.0);
  expectDirection(rays[3], 3 / unit, 0, -1 / unit);
}

TEST(CameraRays, AreUnitLength) {
  for (const Ray &ray : cameraRays(frameExtent({30, 20, 10}, 33, 17)))
    EXPECT_NEAR(length(ray), 1, 1e-6);
}

TEST(CameraRays, LookingAlongUpStillGivesAPicture) {
  Camera camera{.eye = {5, 90, 5}, .look = {5, 0, 5}, .width = 3, .height = 3};
  auto rays = cameraRays(camera);
  expectDirection(rays[4], 0, -1, 0);
  EXPECT_NEAR(length(rays[0]), 1, 1e-6);
}

TEST(FrameExtent, SeesTheWholeBoxAndNotMuchMore) {
  for (Int3 extent : {Int3{64, 64, 64}, Int3{1000, 3, 5}, Int3{2, 900, 7}, Int3{1, 1, 1}}) {
    // Odd sizes: one ray passes through the middle of the box, however thin it is.
    constexpr int kWidth = 161;
    constexpr int kHeight = 91;
    auto rays = cameraRays(frameExtent(extent, kWidth, kHeight));
    int seen = 0;
    for (int row = 0; row < kHeight; ++row)
      for (int column = 0; column < kWidth; ++column) {
        bool hit = meets(rays[std::size_t(row * kWidth + column)], extent);
        seen += hit;
        bool border = row == 0 || column == 0 || row == kHeight - 1 || column == kWidth - 1;
        EXPECT_FALSE(border && hit) << row << " " << column;
      }
    EXPECT_GT(seen, 0);
  }
}

TEST(CameraFromView, IsTheCameraOfTheMatrix) {
  const glm::dvec3 eye(3, 40, -7);
  const glm::dvec3 look(20, 10, 30);
  const Camera camera = cameraFromView(glm::lookAt(eye, look, glm::dvec3(0, 1, 0)), 50, 4, 3);
  const Camera same{.eye = eye, .look = look, .verticalFov = 50, .width = 4, .height = 3};
  const auto rays = cameraRays(camera);
  const auto expected = cameraRays(same);
  ASSERT_EQ(rays.size(), expected.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    expectDirection(rays[i], expected[i].direction[0], expected[i].direction[1], expected[i].direction[2]);
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(rays[i].origin[axis], expected[i].origin[axis], 1e-5);
  }
}

TEST(CameraFromAngles, FollowsTheCameraFiles) {
  // Position is scaled by the longest axis; yaw 0 looks along +z, yaw 90 along +x, pitch up.
  Camera camera = cameraFromAngles({200, 400, 100}, {50, 25, 10}, 0, 90, 90, 3, 3);
  EXPECT_EQ(camera.eye, (glm::dvec3{200, 100, 40}));
  expectDirection(cameraRays(camera)[4], 1, 0, 0);
  expectDirection(cameraRays(cameraFromAngles({9, 9, 9}, {}, 0, 0, 90, 3, 3))[4], 0, 0, 1);
  expectDirection(cameraRays(cameraFromAngles({9, 9, 9}, {}, 30, 0, 90, 3, 3))[4], 0, 0.5, std::sqrt(0.75));
}

TEST(CameraFromAngles, MeasuresScansInSpacedSpace) {
  // The longest axis is z: 100 voxels of 3.
  const Camera camera = cameraFromAngles({200, 200, 100}, {50, 50, 50}, 0, 90, 90, 3, 3, {1, 1, 3});
  EXPECT_EQ(camera.eye, (glm::dvec3{150, 150, 50}));
  EXPECT_EQ(camera.spacing, (glm::dvec3{1, 1, 3}));
}

TEST(Spacing, IsThatOfTheSidesOfVoxels) {
  const auto ofSides = [](double x, double y, double z) {
    return spacingOf(Transform({x, 0, 0}, {0, 0, y}, {0, -z, 0}, {5, 6, 7}));
  };
  EXPECT_EQ(spacingOf({}), glm::dvec3(1));
  EXPECT_EQ(ofSides(0.5, 0.5, 1.5), (glm::dvec3{1, 1, 3}));
  EXPECT_EQ(ofSides(8, 4, 2), (glm::dvec3{4, 2, 1}));
  // Sides that only rounding tells apart are equal; so are voxels of cubes whatever their size.
  EXPECT_EQ(ofSides(double(0.9375f), 0.9375000001, 0.93750000003), glm::dvec3(1));
  EXPECT_EQ(ofSides(1e-30, 1e-30, 1e-30), glm::dvec3(1));
  // Turned.
  EXPECT_EQ(spacingOf(Transform({0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 2}, {})), (glm::dvec3{1, 1, 2}));
  // What no picture can show.
  EXPECT_EQ(ofSides(1, 1, 0), glm::dvec3(1));
  EXPECT_EQ(ofSides(1, 1, INFINITY), glm::dvec3(1));
  EXPECT_EQ(ofSides(1, NAN, 1), glm::dvec3(1));
  EXPECT_EQ(ofSides(1, 1, 1e6), glm::dvec3(1));
}

TEST(CameraRays, GoThroughStretchedVoxelsAsThroughCubes) {
  // The same picture of the same points: rays end where they would in cubes, at the same t.
  const glm::dvec3 spacing(1, 2, 5);
  const Camera cubes{.eye = {3, 40, -7}, .look = {20, 10, 30}, .width = 5, .height = 4};
  Camera scan = cubes;
  scan.eye /= spacing;
  scan.look /= spacing;
  scan.spacing = spacing;
  for (const bool isOrthographic : {false, true}) {
    const auto expected = cameraRays(projected(cubes, isOrthographic));
    const auto rays = cameraRays(projected(scan, isOrthographic));
    ASSERT_EQ(rays.size(), expected.size());
    for (std::size_t i = 0; i < rays.size(); ++i)
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(rays[i].origin[axis] * spacing[axis], expected[i].origin[axis], 1e-4);
        EXPECT_NEAR(rays[i].direction[axis] * spacing[axis], expected[i].direction[axis], 1e-6);
      }
  }
}

TEST(Orthographic, RaysAreParallelAndBeginInThePlaneOfTheEye) {
  const Camera camera{.eye = {1, 2, 3}, .look = {1, 2, -7}, .width = 4, .height = 2, .orthographicHeight = 6};
  const auto rays = cameraRays(camera);
  ASSERT_EQ(rays.size(), 8u);
  for (const Ray &ray : rays) {
    expectDirection(ray, 0, 0, -1);
    EXPECT_EQ(ray.origin[2], 3);
  }
  // Two rows of 3 each, four columns of 3: middles of pixels.
  EXPECT_EQ(rays[0].origin[0], 1 - 4.5f);
  EXPECT_EQ(rays[0].origin[1], 2 + 1.5f);
  EXPECT_EQ(rays[7].origin[0], 1 + 4.5f);
  EXPECT_EQ(rays[7].origin[1], 2 - 1.5f);
  EXPECT_EQ(pixelSpread(camera), 0);
  EXPECT_EQ(shownHeight(camera, 1000), 6);
}

TEST(Orthographic, ShowsAsMuchOfThePlaneLookedAt) {
  const Camera pinhole{.eye = {0, 0, 10}, .look = {0, 0, 0}, .verticalFov = 90};
  const Camera parallel = projected(pinhole, true);
  EXPECT_NEAR(parallel.orthographicHeight, 20, 1e-9);
  EXPECT_EQ(parallel.eye, pinhole.eye);
  // And back, from where so much is seen.
  Camera nearer = parallel;
  nearer.orthographicHeight = 10;
  const Camera back = projected(nearer, false);
  EXPECT_FALSE(back.isOrthographic());
  EXPECT_NEAR(back.eye.z, 5, 1e-9);
  EXPECT_NEAR(shownHeight(back, lookDistance(back)), 10, 1e-9);
}

TEST(CameraFromAngles, RightIsFrontCrossUp) {
  auto rays = cameraRays(cameraFromAngles({9, 9, 9}, {}, 0, 0, 90, 3, 1));
  // Looking along +z with y up, the right hand points along -x.
  EXPECT_GT(rays[0].direction[0], 0.5);
  EXPECT_LT(rays[2].direction[0], -0.5);
}

} // namespace
} // namespace voxc
