// Cutting ears in turn around the polygon, so that triangles are seldom long and thin.
#include "Mesh/EarCutter.h"

#include <algorithm>
#include <cmath>

namespace voxc {

namespace {

using Flat = EarCutter::Flat;

constexpr std::uint64_t kLooksPerCorner = 1 << 11;
constexpr std::uint64_t kFewLooks = 1 << 22;

/// Cells a side at most; corners share them beyond.
constexpr std::size_t kMostCells = 1 << 10;

/// So many cells, a row is taken to be larger on each side than it is, for what rounding may do.
constexpr double kSlack = 0.01;

/// The part of a triangle between two heights, from left to right.
Flat spanOf(const std::array<Flat, 3> &triangle, double low, double high) {
  Flat span{INFINITY, -INFINITY};
  const auto reach = [&](double x) { span = {std::fmin(span[0], x), std::fmax(span[1], x)}; };
  for (std::size_t i = 0; i < 3; ++i) {
    const Flat &a = triangle[i];
    const Flat &b = triangle[(i + 1) % 3];
    if (a[1] >= low && a[1] <= high)
      reach(a[0]);
    for (const double height : {low, high})
      if ((a[1] < height) != (b[1] < height))
        reach(a[0] + (b[0] - a[0]) * ((height - a[1]) / (b[1] - a[1])));
  }
  return span;
}

double turn(const Flat &a, const Flat &b, const Flat &c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

} // namespace

bool EarCutter::cut(std::span<const Flat> corners, std::vector<Corners> &triangles) {
  begin(corners);
  const std::size_t old = triangles.size();
  const std::uint64_t most = kFewLooks + kLooksPerCorner * corners.size();
  std::uint32_t corner = 0;
  std::uint32_t stop = 0;
  Ear kind = Ear::Empty;
  for (std::size_t left = corners.size(); left > 3;) {
    if (++looks_ > most) {
      triangles.resize(old);
      return false;
    }
    const std::uint32_t next = behind_[corner];
    if (isEar(corner, kind)) {
      triangles.push_back({before_[corner], corner, next});
      remove(corner);
      --left;
      // The corner after next: cutting one after the other would make a fan.
      stop = corner = behind_[next];
      kind = Ear::Empty;
    } else if (corner = next; corner == stop) {
      kind = kind == Ear::Empty ? Ear::TouchedAtMost : Ear::Any;
    }
  }
  triangles.push_back({before_[corner], corner, behind_[corner]});
  return true;
}

void EarCutter::begin(std::span<const Flat> corners) {
  corners_ = corners;
  looks_ = 0;
  const auto n = static_cast<std::uint32_t>(corners.size());
  before_.resize(n);
  behind_.resize(n);
  isInward_.resize(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    before_[i] = i == 0 ? n - 1 : i - 1;
    behind_[i] = i + 1 == n ? 0 : i + 1;
  }
  // Not `<= 0`: what is no number turns inwards, too.
  for (std::uint32_t i = 0; i < n; ++i)
    isInward_[i] = !(turnAt(i) > 0);
  makeGrid();
}

void EarCutter::makeGrid() {
  low_ = corners_[0];
  Flat high = corners_[0];
  for (const Flat &point : corners_)
    for (std::size_t axis = 0; axis < 2; ++axis) {
      low_[axis] = std::fmin(low_[axis], point[axis]);
      high[axis] = std::fmax(high[axis], point[axis]);
    }
  side_ =
      std::clamp<std::size_t>(static_cast<std::size_t>(std::sqrt(double(corners_.size()))), 1, kMostCells);
  for (std::size_t axis = 0; axis < 2; ++axis)
    scale_[axis] = static_cast<double>(side_) / (high[axis] - low_[axis]);
  const auto cellOf = [&](const Flat &point) {
    const auto [x, y] = placeOf(point);
    return x + side_ * y;
  };
  firsts_.assign(side_ * side_ + 1, 0);
  for (const Flat &point : corners_)
    ++firsts_[cellOf(point) + 1];
  for (std::size_t cell = 0; cell < side_ * side_; ++cell)
    firsts_[cell + 1] += firsts_[cell];
  inCells_.resize(corners_.size());
  std::vector<std::uint32_t> ends(firsts_.begin(), firsts_.end() - 1);
  for (std::uint32_t i = 0; i < corners_.size(); ++i)
    inCells_[ends[cellOf(corners_[i])]++] = i;
}

std::array<std::size_t, 2> EarCutter::placeOf(const Flat &point) const {
  std::array<std::size_t, 2> place{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double at = (point[axis] - low_[axis]) * scale_[axis];
    // What is no number, as where all corners lie on a line, is in the first cell.
    if (at > 0)
      place[axis] = at < static_cast<double>(side_) ? static_cast<std::size_t>(at) : side_ - 1;
  }
  return place;
}

double EarCutter::turnAt(std::uint32_t corner) const {
  return turn(corners_[before_[corner]], corners_[corner], corners_[behind_[corner]]);
}

bool EarCutter::isEar(std::uint32_t corner, Ear kind) {
  if (kind == Ear::Any)
    return true;
  const double area = turnAt(corner);
  // A corner on a straight edge, or at the end of a spike, takes nothing away.
  if (area == 0)
    return true;
  return area > 0 && !holdsOther({corners_[before_[corner]], corners_[corner], corners_[behind_[corner]]},
                                 kind == Ear::TouchedAtMost);
}

/// Does a triangle that turns left hold a corner that is in none of its own corners' places? Or if it is
/// open, does it hold one that lies on none of its edges?
bool EarCutter::holdsOther(const std::array<Flat, 3> &triangle, bool isOpen) {
  const auto &[a, b, c] = triangle;
  const auto [lowX, lowY] = placeOf({std::min({a[0], b[0], c[0]}), std::min({a[1], b[1], c[1]})});
  const auto [highX, highY] = placeOf({std::max({a[0], b[0], c[0]}), std::max({a[1], b[1], c[1]})});
  const auto holds = [&](const Flat &p) {
    const std::array<double, 3> sides{turn(a, b, p), turn(b, c, p), turn(c, a, p)};
    return std::ranges::all_of(sides, [&](double side) { return isOpen ? side > 0 : side >= 0; }) && p != a &&
           p != b && p != c;
  };
  for (std::size_t y = lowY; y <= highY; ++y) {
    const auto row = static_cast<double>(y);
    const auto [left, right] =
        spanOf(triangle, low_[1] + (row - kSlack) / scale_[1], low_[1] + (row + 1 + kSlack) / scale_[1]);
    if (left > right)
      continue;
    // The cells of a row lie one behind the other; one more on each side makes up for rounding.
    const std::uint32_t first = firsts_[std::max(placeOf({left, 0})[0], lowX + 1) - 1 + side_ * y];
    const std::uint32_t end = firsts_[std::min(placeOf({right, 0})[0] + 1, highX) + side_ * y + 1];
    looks_ += 1 + end - first;
    for (std::uint32_t i = first; i < end; ++i)
      if (isInward_[inCells_[i]] && holds(corners_[inCells_[i]]))
        return true;
  }
  return false;
}

void EarCutter::remove(std::uint32_t corner) {
  const std::uint32_t before = before_[corner];
  const std::uint32_t behind = behind_[corner];
  behind_[before] = behind;
  before_[behind] = before;
  isInward_[corner] = false;
  for (const std::uint32_t neighbour : {before, behind})
    isInward_[neighbour] = !(turnAt(neighbour) > 0);
}

} // namespace voxc
