// Polygons as triangles.
#pragma once

#include "Mesh/EarCutter.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace voxc {

/// Cuts polygons, which need not be quite flat, into triangles.
class PolygonCutter {
public:
  using Point = std::array<double, 3>;
  using Corners = std::array<std::uint32_t, 3>; ///< Of a triangle: which corners of the polygon.

  /// The triangles of a polygon of three corners or more, two less than it has corners. One that is convex
  /// becomes a fan; of others ears are cut off. Valid until the next call.
  std::span<const Corners> cut(std::span<const Point> corners);

  /// How many polygons became fans though they are not convex, since cutting them would have taken too long.
  std::uint64_t badFans() const { return badFans_; }

private:
  using Flat = EarCutter::Flat;

  void flatten(std::span<const Point> corners);
  bool isConvex() const;
  bool isEar(std::size_t place) const;
  void makeFan();
  void cutEars();

  std::vector<Flat> flat_; ///< In the plane that shows most of it; turning left.
  std::vector<std::uint32_t> rest_;
  EarCutter cutter_; ///< For polygons of many corners.
  std::vector<Corners> triangles_;
  std::uint64_t badFans_ = 0;
};

} // namespace voxc
