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

TEST(CameraFromAngles, RightIsFrontCrossUp) {
  auto rays = cameraRays(cameraFromAngles({9, 9, 9}, {}, 0, 0, 90, 3, 1));
  // Looking along +z with y up, the right hand points along -x.
  EXPECT_GT(rays[0].direction[0], 0.5);
  EXPECT_LT(rays[2].direction[0], -0.5);
}

} // namespace
} // namespace voxc
