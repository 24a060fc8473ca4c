// Fans, and ears that are cut off.
#include "Mesh/Polygon.h"

#include <algorithm>
#include <cmath>

namespace voxc {

namespace {

/// Cutting ears one after the other takes up to the cube of the corners.
constexpr std::size_t kFewCorners = 128;

double turn(const std::array<double, 2> &a, const std::array<double, 2> &b, const std::array<double, 2> &c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Newell's normal: twice the area as seen along each axis.
PolygonCutter::Point normalOf(std::span<const PolygonCutter::Point> corners) {
  PolygonCutter::Point normal{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto &a = corners[i];
    const auto &b = corners[i + 1 == corners.size() ? 0 : i + 1];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t u = (axis + 1) % 3;
      const std::size_t v = (axis + 2) % 3;
      normal[axis] += (a[u] - b[u]) * (a[v] + b[v]);
    }
  }
  return normal;
}

} // namespace

std::span<const PolygonCutter::Corners> PolygonCutter::cut(std::span<const Point> corners) {
  triangles_.clear();
  if (corners.size() == 3) {
    triangles_.push_back({0, 1, 2});
    return triangles_;
  }
  flatten(corners);
  if (isConvex()) {
    makeFan();
  } else if (corners.size() <= kFewCorners) {
    cutEars();
  } else if (!cutter_.cut(flat_, triangles_)) {
    ++badFans_;
    makeFan();
  }
  return triangles_;
}

void PolygonCutter::flatten(std::span<const Point> corners) {
  const Point normal = normalOf(corners);
  const auto longer = [](double a, double b) { return std::fabs(a) < std::fabs(b); };
  const auto axis =
      static_cast<std::size_t>(std::max_element(normal.begin(), normal.end(), longer) - normal.begin());
  std::size_t u = (axis + 1) % 3;
  std::size_t v = (axis + 2) % 3;
  if (normal[axis] < 0)
    std::swap(u, v);
  flat_.clear();
  for (const Point &corner : corners)
    flat_.push_back({corner[u], corner[v]});
}

bool PolygonCutter::isConvex() const {
  const std::size_t n = flat_.size();
  for (std::size_t i = 0; i < n; ++i)
    if (turn(flat_[i], flat_[(i + 1) % n], flat_[(i + 2) % n]) < 0)
      return false;
  return true;
}

void PolygonCutter::makeFan() {
  for (std::uint32_t i = 2; i < flat_.size(); ++i)
    triangles_.push_back({0, i - 1, i});
}

/// Does the corner at this place of the rest, with its neighbours, make a triangle that holds no other?
bool PolygonCutter::isEar(std::size_t place) const {
  const std::size_t n = rest_.size();
  const Flat &a = flat_[rest_[(place + n - 1) % n]];
  const Flat &b = flat_[rest_[place]];
  const Flat &c = flat_[rest_[(place + 1) % n]];
  if (turn(a, b, c) < 0)
    return false;
  for (std::size_t i = 2; i + 1 < n; ++i) {
    const Flat &p = flat_[rest_[(place + i) % n]];
    const bool isCorner = p == a || p == b || p == c;
    if (!isCorner && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0)
      return false;
  }
  return true;
}

void PolygonCutter::cutEars() {
  rest_.clear();
  for (std::uint32_t i = 0; i < flat_.size(); ++i)
    rest_.push_back(i);
  std::size_t place = 0;
  while (rest_.size() > 3) {
    const std::size_t n = rest_.size();
    std::size_t tried = 0;
    while (tried < n && !isEar(place % n)) {
      ++place;
      ++tried;
    }
    // Where it crosses itself there may be no ear: then any corner does.
    place %= n;
    triangles_.push_back({rest_[(place + n - 1) % n], rest_[place], rest_[(place + 1) % n]});
    rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(place));
  }
  triangles_.push_back({rest_[0], rest_[1], rest_[2]});
}

} // namespace voxc
