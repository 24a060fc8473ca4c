// The light of pictures: directions to the sky, exposure, what a screen shows.
#include "Render/Exposure.h"
#include "Render/Film.h"
#include "Render/Lighting.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <vector>

namespace voxc {
namespace {

TEST(SkyDirection, GoesAwayFromTheSurfaceAndLiesAboutItsNormal) {
  for (const glm::vec3 normal : {glm::vec3(0, 1, 0), glm::vec3(0, -1, 0), glm::vec3(0.6f, 0, -0.8f)}) {
    glm::vec3 mean(0);
    for (std::uint32_t i = 0; i < 256; ++i) {
      const glm::vec3 direction = skyDirection(normal, evenNumbers(i));
      EXPECT_NEAR(glm::length(direction), 1, 1e-3);
      EXPECT_GT(glm::dot(direction, normal), 0);
      mean += direction / 256.0f;
    }
    // By the cosine, the mean is two thirds of the normal.
    EXPECT_LT(glm::length(mean - normal * (2.0f / 3)), 0.02f);
  }
}

TEST(Openness, FallsWithWhatIsNear) {
  const Hit miss = {{-1, -1, -1}, 0, 0, 0};
  const Hit near = {{0, 0, 0}, 0, 1, 0};
  const Hit far = {{0, 0, 0}, 0, 100, 0};
  EXPECT_EQ(openness(miss, 10), 1);
  EXPECT_LT(openness(near, 10), openness(far, 10));
  EXPECT_LT(openness(far, 10), 1);
}

/// The light of so many pixels, all of this brightness.
std::vector<float> greyLight(float brightness, float hits = 1) {
  std::vector<float> light;
  for (int i = 0; i < 100; ++i)
    light.insert(light.end(), {brightness * hits, brightness * hits, brightness * hits, hits});
  return light;
}

TEST(Exposure, LiftsTheDarkAndLowersTheBright) {
  EXPECT_GT(exposureOf(greyLight(0.02f)), 4);
  EXPECT_LT(exposureOf(greyLight(2.0f)), 0.7f);
  EXPECT_FLOAT_EQ(exposureOf(greyLight(0.4f, 0.6f)), exposureOf(greyLight(0.4f)));
  EXPECT_EQ(exposureOf(greyLight(1, 0)), 1);
}

TEST(Exposure, BlackThingsHaveNoSay) {
  std::vector<float> light = greyLight(0.5f);
  const float alone = exposureOf(light);
  const std::vector<float> black = greyLight(0);
  light.insert(light.end(), black.begin(), black.end());
  EXPECT_FLOAT_EQ(exposureOf(light), alone);
}

TEST(Exposure, OfClayKeepsReliefAndDoesNotBurn) {
  // What sees all of the sky is light, not white; shares that lie close to each other are told apart.
  EXPECT_LT(toScreen(clayOf(1)) * 255, 235);
  EXPECT_GT(toScreen(clayOf(1)) * 255, 215);
  EXPECT_GT((toScreen(clayOf(0.95f)) - toScreen(clayOf(0.85f))) * 255, 18);
  EXPECT_EQ(clayOf(2), clayOf(1));
  EXPECT_EQ(clayOf(0), 0);
  // The brightest are brought to the whole sky, but not out of the deepest dark.
  EXPECT_FLOAT_EQ(skyExposureOf(greyLight(0.5f)), 2);
  EXPECT_FLOAT_EQ(skyExposureOf(greyLight(0.5f, 0.7f)), 2);
  EXPECT_FLOAT_EQ(skyExposureOf(greyLight(0.01f)), 4);
  EXPECT_EQ(skyExposureOf(greyLight(0)), 1);
  EXPECT_EQ(skyExposureOf(greyLight(1, 0)), 1);
}

TEST(Compress, KeepsOrderAndStaysBelowOne) {
  float last = 0;
  for (const float value : {0.1f, 0.5f, 0.7f, 0.9f, 2.0f, 50.0f}) {
    const float shown = compress(glm::vec3(value)).x;
    EXPECT_GT(shown, last);
    EXPECT_LE(shown, 1);
    last = shown;
  }
  EXPECT_EQ(compress(glm::vec3(0.3f, 0.2f, 0.1f)), glm::vec3(0.3f, 0.2f, 0.1f));
}

TEST(Screen, EveryByteComesBack) {
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    const std::uint32_t word = byte | byte << 8 | byte << 16 | 0xff000000u;
    EXPECT_EQ(screenPixel(linearColour(word)), word);
  }
}

TEST(SkyShares, AreSharedOnASurfaceAndNotAcrossSurfaces) {
  Film film(8, 0, 8);
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column) {
      FilmPixel &pixel = film.pixels[film.index(column, row)];
      const bool isFloor = column < 4;
      pixel.hits = 1;
      pixel.normal = isFloor ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
      pixel.point = {float(column), 0, float(row)};
      pixel.sky = isFloor ? float((column + row) % 2) : 0.25f;
    }
  EXPECT_FLOAT_EQ(skyShares(film, 4, true)[2], 0.5f);
  EXPECT_FLOAT_EQ(skyShares(film, 4, true)[6], 0.25f);
  EXPECT_FLOAT_EQ(skyShares(film, 4, false)[2], 0);
}

} // namespace
} // namespace voxc
