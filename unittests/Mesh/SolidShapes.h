// Closed surfaces for tests of solids.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

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

/// The winding number of a point: solid angles over 4 pi (A. van Oosterom and J. Strackee, "The solid angle
/// of a plane triangle", IEEE Transactions on Biomedical Engineering 30, 1983).
inline int windingAt(const Soup &soup, const glm::dvec3 &point) {
  double sum = 0;
  for (std::size_t i = 0; i < soup.size(); i += 3) {
    std::array<glm::dvec3, 3> v;
    std::array<double, 3> length;
    for (std::size_t k = 0; k < 3; ++k) {
      v[k] = glm::dvec3(soup[i + k][0], soup[i + k][1], soup[i + k][2]) - point;
      length[k] = std::sqrt(glm::dot(v[k], v[k]));
    }
    const double volume = glm::dot(v[0], glm::cross(v[1], v[2]));
    const double rest = length[0] * length[1] * length[2] + glm::dot(v[0], v[1]) * length[2] +
                        glm::dot(v[1], v[2]) * length[0] + glm::dot(v[2], v[0]) * length[1];
    sum += 2 * std::atan2(volume, rest);
  }
  return static_cast<int>(std::lround(sum / (4 * std::numbers::pi)));
}

} // namespace voxc::test
