// Where the camera will be: told while it goes on as it did, and not else.
#include "view/CameraPrediction.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace voxc::view {
namespace {

ViewCamera start() { return ViewCamera({.eye = {3, 8, 5}, .look = {40, 2, 30}, .verticalFov = 50}); }

void expectAlike(const ViewCamera &a, const ViewCamera &b, double near) {
  const Camera first = a.camera(1, 1), second = b.camera(1, 1);
  EXPECT_LT(glm::distance(first.eye, second.eye), near);
  EXPECT_LT(glm::distance(first.look, second.look), near);
}

/// What is done in a tenth of a second, again and again.
struct Habit {
  const char *name;
  Turning turning;
  void (*act)(ViewCamera &camera);
};

constexpr Habit kHabits[] = {
    {"orbits", Turning::Orbit, [](ViewCamera &camera) { camera.turn(0.02, -0.01); }},
    {"turns the head", Turning::Fly, [](ViewCamera &camera) { camera.turn(-0.03, 0.01); }},
    {"walks", Turning::Fly, [](ViewCamera &camera) { camera.move(0.5, -0.2, 2); }},
    {"walks in orbit", Turning::Orbit, [](ViewCamera &camera) { camera.move(-1, 0.1, 0.7); }},
    {"comes nearer", Turning::Orbit, [](ViewCamera &camera) { camera.approach(1.05); }},
    {"comes nearer in flight", Turning::Fly, [](ViewCamera &camera) { camera.approach(1.05); }},
};

TEST(CameraPrediction, TellsWhereHabitsLead) {
  for (const Habit &habit : kHabits) {
    SCOPED_TRACE(habit.name);
    ViewCamera camera = start();
    camera.setTurning(habit.turning);
    CameraPrediction prediction;
    EXPECT_EQ(prediction.saw(camera, 0.1), Course::Rests);
    habit.act(camera);
    EXPECT_EQ(prediction.saw(camera, 0.1), Course::Turns);
    habit.act(camera);
    EXPECT_EQ(prediction.saw(camera, 0.1), Course::GoesOn);
    ViewCamera later = camera;
    for (int i = 0; i < 3; ++i)
      habit.act(later);
    expectAlike(prediction.in(0.3), later, 1e-6);
  }
}

TEST(CameraPrediction, TellsWhereACurveLeadsNearly) {
  ViewCamera camera = start();
  camera.setTurning(Turning::Fly);
  CameraPrediction prediction;
  const auto act = [](ViewCamera &one) {
    one.turn(0.02, 0);
    one.move(0, 0, 1);
  };
  for (int i = 0; i < 3; ++i, act(camera))
    prediction.saw(camera, 0.1);
  prediction.saw(camera, 0.1);
  ViewCamera later = camera;
  act(later), act(later);
  EXPECT_GT(glm::distance(camera.camera(1, 1).look, later.camera(1, 1).look), 2);
  expectAlike(prediction.in(0.2), later, 0.1);
}

TEST(CameraPrediction, TakesSpeedFromTime) {
  ViewCamera camera = start();
  CameraPrediction prediction;
  for (int i = 0; i < 3; ++i, camera.move(0, 0, 1))
    prediction.saw(camera, 0.5);
  prediction.saw(camera, 0.5);
  ViewCamera later = camera;
  later.move(0, 0, 4);
  expectAlike(prediction.in(2), later, 1e-9);
}

TEST(CameraPrediction, NoticesATurn) {
  ViewCamera camera = start();
  CameraPrediction prediction;
  for (int i = 0; i < 3; ++i, camera.turn(0.05, 0))
    prediction.saw(camera, 0.1);
  EXPECT_EQ(prediction.saw(camera, 0.1), Course::GoesOn);
  camera.turn(-0.05, 0);
  EXPECT_EQ(prediction.saw(camera, 0.1), Course::Turns);
  camera.turn(-0.05, 0);
  EXPECT_EQ(prediction.saw(camera, 0.1), Course::GoesOn);
  camera.turn(0, 0.05);
  EXPECT_EQ(prediction.saw(camera, 0.1), Course::Turns);
  camera.move(0, 0, 4);
  EXPECT_EQ(prediction.saw(camera, 0.1), Course::Turns);
}

TEST(CameraPrediction, NoticesRestAfterAMoment) {
  ViewCamera camera = start();
  CameraPrediction prediction;
  for (int i = 0; i < 3; ++i, camera.turn(0.05, 0))
    prediction.saw(camera, 0.1);
  EXPECT_EQ(prediction.saw(camera, 0.1), Course::GoesOn);
  EXPECT_EQ(prediction.saw(camera, 0.02), Course::GoesOn);
  EXPECT_EQ(prediction.saw(camera, 0.2), Course::Rests);
  EXPECT_EQ(prediction.saw(camera, 0.01), Course::Rests);
  camera.turn(0.05, 0);
  EXPECT_EQ(prediction.saw(camera, 0.1), Course::Turns);
}

TEST(CameraPrediction, ForgetsAnotherScene) {
  ViewCamera camera = start();
  CameraPrediction prediction;
  for (int i = 0; i < 4; ++i, camera.turn(0.05, 0))
    prediction.saw(camera, 0.1);
  prediction.forget();
  EXPECT_EQ(prediction.saw(camera, 0.1), Course::Rests);
}

} // namespace
} // namespace voxc::view
