// Polygons of many corners as triangles: ears are cut off, and a grid tells which corners may lie in one.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace voxc {

/// Cuts ears off flat polygons (G. Meisters, "Polygons have ears", American Mathematical Monthly 82, 1975).
/// Only corners that turn inwards can lie in an ear, and few of them near it are looked at.
class EarCutter {
public:
  using Flat = std::array<double, 2>;
  using Corners = std::array<std::uint32_t, 3>;

  /// Adds the triangles of a polygon that turns left, two less than it has corners, of which it has four or
  /// more. It may touch or cross itself; then where it has no ear some corner is cut off all the same. False,
  /// with `triangles` as they were, if that takes more than about 2000 looks a corner.
  bool cut(std::span<const Flat> corners, std::vector<Corners> &triangles);

private:
  /// What a triangle may hold and yet be an ear.
  enum class Ear : std::uint8_t { Empty, TouchedAtMost, Any };

  void begin(std::span<const Flat> corners);
  void makeGrid();
  std::array<std::size_t, 2> placeOf(const Flat &point) const;
  double turnAt(std::uint32_t corner) const;
  bool isEar(std::uint32_t corner, Ear kind);
  bool holdsOther(const std::array<Flat, 3> &triangle, bool isOpen);
  void remove(std::uint32_t corner);

  std::span<const Flat> corners_;
  std::vector<std::uint32_t> before_;
  std::vector<std::uint32_t> behind_;
  std::vector<bool> isInward_;         ///< Is still there, and turns right or goes straight on.
  std::size_t side_ = 1;               ///< Cells of the grid on each axis.
  std::vector<std::uint32_t> firsts_;  ///< Where the corners of each cell begin in `inCells_`, and the end.
  std::vector<std::uint32_t> inCells_; ///< Corners, cell by cell.
  Flat low_{};
  Flat scale_{}; ///< Cells a unit.
  std::uint64_t looks_ = 0;
};

} // namespace voxc
