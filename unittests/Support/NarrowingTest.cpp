// The compiler that built this rounds what is made float32 (cmake/VoxcRounding.cmake): where it does not,
// voxels, points and rays would be others than those of another build.
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace voxc {
namespace {

using Position = std::array<double, 3>;

/// A double rounded to 24 bits, to nearest and ties to even, by arithmetic on integers alone; for ordinary
/// numbers.
double roundedByBits(double number) {
  constexpr int kDropped = 53 - 24;
  constexpr std::uint64_t kHalf = std::uint64_t{1} << (kDropped - 1);
  std::uint64_t bits = std::bit_cast<std::uint64_t>(number);
  const std::uint64_t isOdd = bits >> kDropped & 1;
  bits += kHalf - 1 + isOdd;
  bits &= ~std::uint64_t{0} << kDropped;
  return std::bit_cast<double>(bits);
}

std::vector<Position> positions() {
  std::mt19937_64 random(1);
  std::vector<Position> result(1000);
  for (Position &position : result)
    for (double &coordinate : position)
      coordinate = std::ldexp(static_cast<double>(random() >> 11), -static_cast<int>(random() % 80)) *
                   (random() % 2 == 0 ? 1 : -1);
  return result;
}

glm::vec3 narrowed(const Position &p) {
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}

/// How points and corners come to voxels: rounded, moved, scaled.
[[gnu::noinline]] glm::dvec3 moved(const Position &position, const glm::dvec3 &origin, double scale) {
  return (glm::dvec3(narrowed(position)) - origin) * scale;
}

[[gnu::noinline]] std::array<double, 2> pair(const Position &position) {
  return {static_cast<float>(position[0]), static_cast<float>(position[1])};
}

/// How cameras and boxes are handed to devices.
[[gnu::noinline]] glm::dvec3 throughVector(const glm::dvec3 &v) { return glm::dvec3(glm::vec3(v)); }

[[gnu::noinline]] void throughArray(const double *from, double *to, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    to[i] = static_cast<float>(from[i]);
}

TEST(Narrowing, RoundsEveryComponentOfAVector) {
  for (const Position &position : positions()) {
    const glm::dvec3 rounded(roundedByBits(position[0]), roundedByBits(position[1]),
                             roundedByBits(position[2]));
    EXPECT_EQ(throughVector({position[0], position[1], position[2]}), rounded);
    EXPECT_EQ(moved(position, glm::dvec3(0), 1), rounded);
    EXPECT_EQ(moved(position, rounded, 1), glm::dvec3(0));
    EXPECT_EQ(pair(position), (std::array<double, 2>{rounded.x, rounded.y}));
  }
}

TEST(Narrowing, RoundsEveryElementOfAnArray) {
  const std::vector<Position> from = positions();
  std::vector<double> to(from.size() * 3);
  throughArray(from.front().data(), to.data(), to.size());
  for (std::size_t i = 0; i < to.size(); ++i)
    EXPECT_EQ(to[i], roundedByBits(from[i / 3][i % 3])) << i;
}

} // namespace
} // namespace voxc
