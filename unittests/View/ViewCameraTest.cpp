// What keys and the mouse do to the camera.
#include "view/ViewCamera.h"
#include "view/Motion.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace voxc::view {
namespace {

constexpr double kNear = 1e-9;

void expectNear(const glm::dvec3 &a, const glm::dvec3 &b) {
  EXPECT_LT(glm::distance(a, b), 1e-6)
      << a.x << " " << a.y << " " << a.z << " is not " << b.x << " " << b.y << " " << b.z;
}

/// Looks along +x from the origin, at a point 10 voxels away.
Camera ahead() { return {.eye = {0, 0, 0}, .look = {10, 0, 0}, .verticalFov = 50}; }

TEST(ViewCamera, BeginsWhereTheCameraStands) {
  const Camera camera = ViewCamera(ahead()).camera(320, 200);
  expectNear(camera.eye, {0, 0, 0});
  expectNear(camera.look, {10, 0, 0});
  expectNear(camera.up, {0, 1, 0});
  EXPECT_EQ(camera.verticalFov, 50);
  EXPECT_EQ(camera.width, 320);
  EXPECT_EQ(camera.height, 200);
}

TEST(ViewCamera, OrbitKeepsThePointLookedAt) {
  ViewCamera camera(ahead());
  camera.turn(glm::radians(90.0), 0);
  expectNear(camera.camera(1, 1).look, {10, 0, 0});
  // Turned to the right of +x, it looks along +z.
  expectNear(camera.camera(1, 1).eye, {10, 0, -10});
  camera.turn(0, glm::radians(30.0));
  expectNear(camera.camera(1, 1).look, {10, 0, 0});
  EXPECT_NEAR(camera.camera(1, 1).eye.y, -5, kNear);
}

TEST(ViewCamera, FlyKeepsTheEye) {
  ViewCamera camera(ahead());
  camera.setTurning(Turning::Fly);
  camera.turn(glm::radians(-90.0), 0);
  expectNear(camera.camera(1, 1).eye, {0, 0, 0});
  expectNear(camera.camera(1, 1).look, {0, 0, -10});
}

TEST(ViewCamera, StopsShortOfStraightUpAndDown) {
  for (const double up : {glm::radians(200.0), glm::radians(-200.0)}) {
    ViewCamera camera(ahead());
    camera.setTurning(Turning::Fly);
    camera.turn(0, up);
    const glm::dvec3 look = camera.camera(1, 1).look;
    EXPECT_GT(look.y * up, 0);
    EXPECT_NEAR(look.x, 10 * std::sin(glm::radians(1.0)), 1e-6);
  }
}

TEST(ViewCamera, BeginsStraightDownWithThePicturesWayUp) {
  const Camera down{.eye = {5, 20, 5}, .look = {5, 0, 5}, .up = {0, 0, -1}};
  const Camera camera = ViewCamera(down).camera(1, 1);
  expectNear(camera.look, {5, 0, 5});
  expectNear(camera.up, {0, 1, 0});
  EXPECT_NEAR(camera.eye.x, 5, kNear);
  // Tilted by a degree, and what was up in the picture is ahead.
  EXPECT_NEAR(camera.eye.z, 5 + 20 * std::sin(glm::radians(1.0)), 1e-6);
}

TEST(ViewCamera, KeepsTheWayUpOfARolledCamera) {
  const Camera rolled{.eye = {0, 0, 0}, .look = {10, 0, 0}, .up = {0, 0, 1}};
  expectNear(ViewCamera(rolled).camera(1, 1).up, {0, 0, 1});
}

TEST(ViewCamera, MovesAlongWhatItSees) {
  ViewCamera camera(ahead());
  camera.move(1, 2, 3);
  expectNear(camera.camera(1, 1).eye, {3, 2, 1});
  expectNear(camera.camera(1, 1).look, {13, 2, 1});
}

TEST(ViewCamera, ApproachesThePointLookedAt) {
  ViewCamera camera(ahead());
  camera.approach(4);
  expectNear(camera.camera(1, 1).eye, {7.5, 0, 0});
  EXPECT_NEAR(camera.distance(), 2.5, kNear);
  camera.approach(1e30);
  EXPECT_GT(camera.distance(), 0);
}

TEST(ViewCamera, LooksAtAPointFromWhereItIs) {
  ViewCamera camera(ahead());
  camera.lookAt({0, 3, 4});
  expectNear(camera.camera(1, 1).eye, {0, 0, 0});
  expectNear(camera.camera(1, 1).look, {0, 3, 4});
  camera.lookAt({0, 0, 0});
  expectNear(camera.camera(1, 1).look, {0, 3, 4});
}

TEST(ViewCamera, MovesInSpacedSpace) {
  // Slices lie 3 apart: a quarter of a turn around a point goes as far in mm, which is a third in slices.
  const Camera scan{.eye = {-30, 0, 0}, .look = {0, 0, 0}, .spacing = {1, 1, 3}};
  ViewCamera camera(scan);
  EXPECT_NEAR(camera.distance(), 30, kNear);
  camera.turn(glm::radians(90.0), 0);
  expectNear(camera.camera(1, 1).eye, {0, 0, -10});
  EXPECT_EQ(camera.camera(1, 1).spacing, scan.spacing);
  camera.approach(2);
  expectNear(camera.camera(1, 1).eye, {0, 0, -5});
  camera.lookAt({0, 0, 5});
  EXPECT_NEAR(camera.distance(), 30, kNear);
}

TEST(ViewCamera, ByParallelRaysShowsLessInsteadOfGoingNearer) {
  ViewCamera camera(ahead());
  camera.setOrthographic(true);
  EXPECT_TRUE(camera.isOrthographic());
  const double height = camera.camera(1, 1).orthographicHeight;
  EXPECT_NEAR(height, 20 * std::tan(glm::radians(25.0)), kNear);
  camera.approach(4);
  EXPECT_NEAR(camera.camera(1, 1).orthographicHeight, height / 4, kNear);
  expectNear(camera.camera(1, 1).eye, {0, 0, 0});
  // A pinhole shows the same from a fourth of the way.
  camera.setOrthographic(false);
  expectNear(camera.camera(1, 1).eye, {7.5, 0, 0});
  expectNear(camera.camera(1, 1).look, {10, 0, 0});
}

TEST(Motion, ATapIsAlwaysTheSameStep) {
  for (const int calls : {1, 3}) {
    ViewCamera camera(ahead());
    Motion motion;
    motion.press(Action::Forward);
    for (int i = 0; i < calls; ++i)
      motion.advance(camera, 0.01, 100);
    motion.release(Action::Forward);
    EXPECT_TRUE(motion.advance(camera, 5, 100));
    EXPECT_FALSE(motion.isMoving());
    EXPECT_FALSE(motion.advance(camera, 5, 100));
    EXPECT_NEAR(camera.camera(1, 1).eye.x, 100 * Motion::kTap, kNear);
  }
}

TEST(Motion, AKeyThatIsReleasedBeforeItIsSeenStillActs) {
  ViewCamera camera(ahead());
  Motion motion;
  motion.press(Action::Left);
  motion.release(Action::Left);
  EXPECT_TRUE(motion.advance(camera, 0.01, 100));
  EXPECT_NEAR(camera.camera(1, 1).eye.z, -100 * Motion::kTap, kNear);
}

TEST(Motion, AHeldKeyActsForItsTime) {
  ViewCamera camera(ahead());
  Motion motion;
  motion.press(Action::Up);
  for (int i = 0; i < 100; ++i)
    motion.advance(camera, 0.02, 10);
  motion.releaseAll();
  motion.advance(camera, 0.02, 10);
  EXPECT_NEAR(camera.camera(1, 1).eye.y, 10 * 2, 1e-6);
}

TEST(Motion, OtherKeysMoveNothing) {
  ViewCamera camera(ahead());
  Motion motion;
  motion.press(Action::Screenshot);
  EXPECT_FALSE(motion.isMoving());
}

} // namespace
} // namespace voxc::view
