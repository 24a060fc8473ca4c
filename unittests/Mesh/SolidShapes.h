// Closed surfaces for tests of solids.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace voxc::test {

using Corner = std::array<float, 3>;
using Soup = std::vector<Corner>; ///< Three corners a triangle.

inline Soup flipped(Soup soup) {
  for (std::size_t i = 0; i < soup.size(); i += 3)
    std::swap(soup[i + 1], soup[i + 2]);
  return soup;
}

inline Soup joined(Soup a, const Soup &b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// A surface with the topology of a torus or, where rows end in points, of a sphere.
template <typename Point> Soup lattice(int rows, int columns, Point point) {
  Soup soup;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const std::array<Corner, 4> square{point(i, j), point(i + 1, j), point(i + 1, (j + 1) % columns),
                                         point(i, (j + 1) % columns)};
      soup.insert(soup.end(), {square[0], square[1], square[2], square[0], square[2], square[3]});
    }
  return soup;
}

inline Soup sphere(double radius, Corner centre = {0.5f, 0.5f, 0.5f}, int parts = 14) {
  return lattice(parts, 2 * parts, [=](int i, int j) {
    const double polar = std::numbers::pi * i / parts;
    // The poles are one point each.
    const double ring = i == 0 || i == parts ? 0 : radius * std::sin(polar);
    const double turn = std::numbers::pi * j / parts;
    return Corner{static_cast<float>(centre[0] + ring * std::cos(turn)),
                  static_cast<float>(centre[1] + radius * std::cos(polar)),
                  static_cast<float>(centre[2] + ring * std::sin(turn))};
  });
}

inline Soup torus(double large, double small) {
  constexpr int kParts = 24;
  return lattice(kParts, kParts, [=](int i, int j) {
    const double u = 2 * std::numbers::pi * (i % kParts) / kParts;
    const double v = 2 * std::numbers::pi * j / kParts;
    const double ring = large + small * std::cos(v);
    return Corner{static_cast<float>(0.5 + ring * std::cos(u)), static_cast<float>(0.5 + small * std::sin(v)),
                  static_cast<float>(0.5 + ring * std::sin(u))};
  });
}

inline Soup box(Corner low, Corner high) {
  Soup soup;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool isHigh : {false, true}) {
      std::array<Corner, 4> square;
      for (std::size_t i = 0; i < 4; ++i) {
        square[i][axis] = (isHigh ? high : low)[axis];
        square[i][(axis + 1) % 3] = (i % 2 == 0 ? low : high)[(axis + 1) % 3];
        square[i][(axis + 2) % 3] = (i / 2 == 0 ? low : high)[(axis + 2) % 3];
      }
      Soup face{square[0], square[1], square[2], square[1], square[3], square[2]};
      soup = joined(std::move(soup), isHigh ? face : flipped(face));
    }
  return soup;
}

inline Soup cube(float low, float high) { return box({low, low, low}, {high, high, high}); }

} // namespace voxc::test
