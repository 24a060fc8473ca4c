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

/// The area of a flat polygon in the plane z = 0, with its sign.
double signedAreaOf(const std::vector<Point> &corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point &a = corners[i];
    const Point &b = corners[(i + 1) % corners.size()];
    sum += (a[0] * b[1] - a[1] * b[0]) / 2;
  }
  return sum;
}

/// Held against the polygon: triangles all turn as it does, add up to its area, and lie in it.
void expectCut(std::vector<Point> corners) {
  for (int way = 0; way < 2; ++way, std::reverse(corners.begin(), corners.end())) {
    const double whole = signedAreaOf(corners);
    PolygonCutter cutter;
    const auto triangles = cutter.cut(corners);
    ASSERT_EQ(triangles.size(), corners.size() - 2);
    EXPECT_EQ(cutter.badFans(), 0u);
    double sum = 0;
    for (const auto &[a, b, c] : triangles) {
      const double part = signedAreaOf({corners[a], corners[b], corners[c]});
      EXPECT_GE(part / whole, 0);
      sum += part;
    }
    EXPECT_NEAR(sum / whole, 1, 1e-9);
  }
}

Point polar(double radius, double turns) {
  return {radius * std::cos(2 * M_PI * turns), radius * std::sin(2 * M_PI * turns), 0};
}

TEST(Polygon, ManyCornersAreNoReasonForAFan) {
  std::vector<Point> gear;
  for (int i = 0; i < 1000; ++i)
    gear.push_back(polar(i / 2 % 2 == 0 ? 10 : 8, i / 1000.0));
  expectCut(gear);
  // A band that goes round 20 times.
  std::vector<Point> spiral;
  for (int i = 0; i < 4000; ++i)
    spiral.push_back(polar(1 + i / 200.0, i / 200.0));
  for (int i = 4000; i-- > 0;)
    spiral.push_back(polar(1.4 + i / 200.0, i / 200.0));
  expectCut(spiral);
  // A comb on whole numbers, with corners on straight edges.
  std::vector<Point> comb{{0, 0, 0}, {0, 9, 0}};
  for (int i = 1; i < 2000; ++i)
    comb.insert(comb.end(), {{i - 0.5, i % 4 < 2 ? 1.0 : 9.0, 0}, {double(i), i % 4 < 2 ? 9.0 : 1.0, 0}});
  comb.push_back({2000, 0, 0});
  comb.push_back({1000, 0, 0});
  expectCut(comb);
  std::mt19937 random(3);
  std::vector<Point> star;
  for (int i = 0; i < 50000; ++i)
    star.push_back(polar(1 + random() % 1000 / 100.0, i / 50000.0));
  expectCut(star);
}

TEST(Polygon, AHoleThatAnEdgeLeadsToStaysOne) {
  // Round the outside, along an edge to the hole, round it the other way and back along the edge.
  std::vector<Point> ring;
  for (int i = 0; i <= 200; ++i)
    ring.push_back(polar(5, i % 200 / 200.0));
  for (int i = 200; i >= 0; --i)
    ring.push_back(polar(3, i % 200 / 200.0));
  expectCut(ring);
}

TEST(Polygon, WhateverItIsItEnds) {
  EXPECT_EQ(cut({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}).size(), 3u);
  EXPECT_EQ(cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size(), 2u);
  EXPECT_EQ(cut({{0, 0, 0}, {NAN, 1, 0}, {1, INFINITY, 0}, {0, 1, 0}}).size(), 2u);
  std::vector<Point> many;
  for (int i = 0; i < 1000; ++i)
    many.push_back({double(i), double(i % 7), 0});
  EXPECT_EQ(cut(many).size(), 998u);
  std::mt19937 random(11);
  for (const int kind : {0, 1, 2, 3}) {
    // Tangles on few places, on a line, in one place, and such of no numbers.
    std::vector<Point> tangle;
    for (int i = 0; i < 3000; ++i)
      tangle.push_back({double(random() % 50), kind == 0 ? double(random() % 50) : kind == 3 ? NAN : 0, 0});
    if (kind == 2)
      tangle.assign(3000, {1, 2, 3});
    EXPECT_EQ(cut(tangle).size(), 2998u) << kind;
  }
  // One that would take too long is a fan, and is counted.
  std::vector<Point> knot;
  for (int i = 0; i < 40000; ++i)
    knot.push_back({double(random() % 100000), double(random() % 100000), 0});
  PolygonCutter cutter;
  EXPECT_EQ(cutter.cut(knot).size(), knot.size() - 2);
  EXPECT_EQ(cutter.badFans(), 1u);
}

} // namespace
} // namespace voxc
