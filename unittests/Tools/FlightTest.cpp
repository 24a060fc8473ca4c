// Flights go through their cameras, and not beyond.
#include "common/Flight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace voxc::tool {
namespace {

using ::testing::HasSubstr;

Expected<Flight> flightOf(const std::string &cameras, const std::string &size = "[64, 48]") {
  const auto path = std::filesystem::path(::testing::TempDir()) / "flight.json";
  std::ofstream(path) << R"({"size": )" << size << R"(, "cameras": {)" << cameras << "}}";
  return Flight::through(path.string());
}

std::string cameraAt(const std::string &name, double x, double yaw, double fov = 60) {
  return "\"" + name + "\": {\"position\": [" + std::to_string(x) +
         ", 2, 3], \"pitch\": 5, \"yaw\": " + std::to_string(yaw) + ", \"fov\": " + std::to_string(fov) + "}";
}

TEST(Flight, IsAtEachCameraInItsTurn) {
  const auto flight = flightOf(cameraAt("z", 10, 300) + "," + cameraAt("a", 20, 375) + "," +
                               cameraAt("m", 12, 375, 170) + "," + cameraAt("b", 0.1, -10));
  ASSERT_TRUE(flight);
  const double x[] = {10, 20, 12, 0.1}, yaw[] = {300, 375, 375, -10}, fov[] = {60, 60, 170, 60};
  for (unsigned i = 0; i < 4; ++i)
    for (const unsigned frames : {4u, 100u, 31u}) {
      const FileCamera camera = flight->at(i * ((frames - 1) / 3), frames);
      EXPECT_EQ(camera.position, glm::dvec3(x[i], 2, 3));
      EXPECT_EQ(camera.pitch, 5);
      EXPECT_EQ(camera.yaw, yaw[i]);
      EXPECT_EQ(camera.fov, fov[i]);
      EXPECT_EQ(camera.size, (std::array{64, 48}));
    }
  EXPECT_EQ(flight->at(0, 1).position.x, 10);
}

TEST(Flight, SizesThatAreNoneAreErrors) {
  for (const char *size : {"[0, 48]", "[64]", "\"64x48\"", "[64, 40000]", "null"}) {
    const auto flight = flightOf(cameraAt("a", 0, 0) + "," + cameraAt("b", 1, 0), size);
    ASSERT_FALSE(flight) << size;
    EXPECT_THAT(flight.error().message, HasSubstr("should have a size of two numbers from 1 to 32768"));
  }
}

TEST(Flight, NeverGoesBeyondTwoCamerasNorJumps) {
  const auto flight = flightOf(cameraAt("1", 0, 0) + "," + cameraAt("2", 1, 0) + "," + cameraAt("3", 50, 0) +
                               "," + cameraAt("4", 49, 0));
  ASSERT_TRUE(flight);
  constexpr unsigned kFrames = 3001;
  const double x[] = {0, 1, 50, 49};
  double before = 0, step = 0;
  for (unsigned frame = 0; frame < kFrames - 1; ++frame) {
    const double place = flight->at(frame, kFrames).position.x;
    const double a = x[frame / 1000], b = x[frame / 1000 + 1];
    EXPECT_GE(place, std::min(a, b));
    EXPECT_LE(place, std::max(a, b));
    if (frame > 1) {
      EXPECT_LT(std::abs(place - before - step), 0.001) << "the speed jumps at frame " << frame;
    }
    step = place - before;
    before = place;
  }
}

TEST(Flight, NeedsTwoCameras) {
  const auto flight = flightOf(cameraAt("alone", 1, 2));
  ASSERT_FALSE(flight);
  EXPECT_THAT(flight.error().message, HasSubstr("should have two cameras or more"));
  EXPECT_FALSE(flightOf(cameraAt("1", 1, 2) + R"(, "2": {"position": [1, 2]})"));
  EXPECT_FALSE(Flight::through("no-such-file.json"));
}

/// Cameras so far apart that their steps cannot be reckoned with would give frames without a place.
TEST(Flight, RefusesCamerasBeyondAllPlaces) {
  EXPECT_TRUE(flightOf(cameraAt("1", 1e12, 2) + "," + cameraAt("2", -1e12, 2) + "," + cameraAt("3", 0, 2)));
  const auto flight =
      flightOf(cameraAt("1", 0, 2) + "," + cameraAt("2", 1e300, 2) + "," + cameraAt("3", 1e308, 2));
  ASSERT_FALSE(flight);
  EXPECT_THAT(flight.error().message, HasSubstr("none beyond 10^12"));
}

} // namespace
} // namespace voxc::tool
