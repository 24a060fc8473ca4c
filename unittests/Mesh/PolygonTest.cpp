// Polygons are cut into triangles that cover them and nothing else.
#include "Mesh/Polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace voxc {
namespace {

using Point = PolygonCutter::Point;
using Triples = std::vector<PolygonCutter::Corners>;

Triples cut(const std::vector<Point> &corners) {
  PolygonCutter cutter;
  const auto triangles = cutter.cut(corners);
  return {triangles.begin(), triangles.end()};
}

Point cross(const Point &a, const Point &b, const Point &c) {
  Point u;
  Point v;
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] = b[i] - a[i];
    v[i] = c[i] - a[i];
  }
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

double area(const Point &a, const Point &b, const Point &c) {
  const auto [x, y, z] = cross(a, b, c);
  return std::sqrt(x * x + y * y + z * z) / 2;
}

double areaOf(const std::vector<Point> &corners, const Triples &triangles) {
  double sum = 0;
  for (const auto &[a, b, c] : triangles)
    sum += area(corners[a], corners[b], corners[c]);
  return sum;
}

TEST(Polygon, ConvexOnesAreFans) {
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), (Triples{{0, 1, 2}}));
  EXPECT_EQ(cut({{0, 0, 5}, {1, 0, 5}, {1, 1, 5}, {0, 1, 5}}), (Triples{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(cut({{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}}), (Triples{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Polygon, AnArrowKeepsItsNotch) {
  // The fan from the first corner would cover the notch.
  const std::vector<Point> arrow{{2, 0, 0}, {0, 2, 0}, {-2, 0, 0}, {0, 1, 0}};
  for (std::size_t turn = 0; turn < 4; ++turn) {
    std::vector<Point> turned = arrow;
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(turn), turned.end());
    EXPECT_DOUBLE_EQ(areaOf(turned, cut(turned)), 2);
    std::reverse(turned.begin(), turned.end());
    EXPECT_DOUBLE_EQ(areaOf(turned, cut(turned)), 2);
  }
}

TEST(Polygon, RandomStarsAreCoveredOnce) {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    const std::size_t n = 4 + random() % 40;
    std::vector<Point> star;
    double whole = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = 2 * 3.14159265358979 * static_cast<double>(i) / static_cast<double>(n);
      const double radius = 1 + random() % 5;
      // In a plane that lies askew.
      const double x = radius * std::cos(angle);
      const double y = radius * std::sin(angle);
      star.push_back({x, y, x / 2 - y});
    }
    for (std::size_t i = 0; i < n; ++i)
      whole += area({0, 0, 0}, star[i], star[(i + 1) % n]);
    const Triples triangles = cut(star);
    EXPECT_EQ(triangles.size(), n - 2);
    EXPECT_NEAR(areaOf(star, triangles), whole, whole * 1e-9) << n;
  }
}

TEST(Polygon, WhateverItIsItEnds) {
  EXPECT_EQ(cut({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}).size(), 3u);
  EXPECT_EQ(cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size(), 2u);
  EXPECT_EQ(cut({{0, 0, 0}, {NAN, 1, 0}, {1, INFINITY, 0}, {0, 1, 0}}).size(), 2u);
  std::vector<Point> many;
  for (int i = 0; i < 1000; ++i)
    many.push_back({double(i), double(i % 7), 0});
  EXPECT_EQ(cut(many).size(), 998u);
}

} // namespace
} // namespace voxc
