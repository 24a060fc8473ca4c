// Nearest points of triangles against all points of a fine mesh on them.
#include "TestLength.h"

#include "Mesh/Voxelize/NearestPoint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace voxc {
namespace {

using Corners = std::array<glm::dvec3, 3>;

double distanceSquared(const Corners &triangle, const glm::dvec3 &weights, const glm::dvec3 &point) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    double at = -point[axis];
    for (int corner = 0; corner < 3; ++corner)
      at += weights[corner] * triangle[static_cast<std::size_t>(corner)][axis];
    sum += at * at;
  }
  return sum;
}

/// The smallest squared distance of points that are 1/64 of an edge apart.
double sampled(const Corners &triangle, const glm::dvec3 &point) {
  constexpr int kParts = 64;
  double least = INFINITY;
  for (int i = 0; i <= kParts; ++i)
    for (int j = 0; i + j <= kParts; ++j) {
      const double b = static_cast<double>(i) / kParts;
      const double c = static_cast<double>(j) / kParts;
      least = std::fmin(least, distanceSquared(triangle, {1 - b - c, b, c}, point));
    }
  return least;
}

double longestEdge(const Corners &triangle) {
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i)
    longest =
        std::fmax(longest, distanceSquared(triangle, {i == 0 ? 1.0 : 0, i == 1 ? 1.0 : 0, i == 2 ? 1.0 : 0},
                                           triangle[(i + 1) % 3]));
  return std::sqrt(longest);
}

void expectNearest(const Corners &triangle, const glm::dvec3 &point) {
  const NearestPoint nearest = NearestPoints(triangle).to(point);
  EXPECT_NEAR(nearest.weights[0] + nearest.weights[1] + nearest.weights[2], 1, 1e-12);
  for (int corner = 0; corner < 3; ++corner)
    EXPECT_TRUE(nearest.weights[corner] >= 0 && nearest.weights[corner] <= 1) << nearest.weights[corner];
  EXPECT_NEAR(nearest.distanceSquared, distanceSquared(triangle, nearest.weights, point), 1e-9);
  const double least = std::sqrt(sampled(triangle, point));
  const double found = std::sqrt(nearest.distanceSquared);
  EXPECT_LE(found, least + 1e-9);
  EXPECT_GE(found, least - longestEdge(triangle) / 64);
}

TEST(NearestPoint, NoPointOfTheTriangleIsNearer) {
  std::mt19937 random(1);
  const auto coordinate = [&] { return static_cast<double>(random() % 4096) / 256 - 8; };
  const auto point = [&] { return glm::dvec3{coordinate(), coordinate(), coordinate()}; };
  for (int i = 0; i < test::rounds(1000); ++i) {
    Corners triangle{point(), point(), point()};
    if (i % 4 == 1) // A segment.
      triangle[random() % 3] = triangle[random() % 3];
    if (i % 4 == 2) // A needle, of which one side is far shorter than the others.
      for (int axis = 0; axis < 3; ++axis)
        triangle[2][axis] = triangle[1][axis] + static_cast<double>(random() % 3) / 4096;
    expectNearest(triangle, point());
  }
}

TEST(NearestPoint, ThinTrianglesAreNoWorseThanTheirEdges) {
  std::mt19937 random(2);
  for (int i = 0; i < test::rounds(300); ++i) {
    // Corners almost on a line, in all orders.
    Corners triangle{
        {{0, 0, 0}, {1000, 1, 0}, {500, 0.5 + std::ldexp(1, -static_cast<int>(random() % 50)), 0}}};
    std::shuffle(triangle.begin(), triangle.end(), random);
    const double x = static_cast<double>(random() % 1000);
    const NearestPoint nearest = NearestPoints(triangle).to({x, x / 1000, 0.5});
    EXPECT_LT(nearest.distanceSquared, 0.26);
    EXPECT_GT(nearest.distanceSquared, 0.24);
  }
}

TEST(NearestPoint, ComparedDistancesForgetRoundingAndEnd) {
  EXPECT_EQ(comparedDistance(0), 0u);
  EXPECT_EQ(comparedDistance(0.5), comparedDistance(0.5 + 0x1p-40));
  EXPECT_LT(comparedDistance(0.5), comparedDistance(0.5 + 0x1p-29));
  EXPECT_EQ(comparedDistance(1e300), 0xfffffffeu);
  EXPECT_EQ(comparedDistance(NAN), 0xfffffffeu);
}

} // namespace
} // namespace voxc
