// Finding which rims hang together, and their middles.
#include "Mesh/Solid/HoleCaps.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace voxc {

namespace {

constexpr std::uint64_t kMostTriangles = 1 << 20;

/// Corners of rims, in order, and sets of those that edges join.
class RimCorners {
public:
  explicit RimCorners(std::span<const RimEdge> rims) {
    for (const RimEdge &rim : rims)
      corners_.insert(corners_.end(), rim.ends.begin(), rim.ends.end());
    std::ranges::sort(corners_);
    const auto surplus = std::ranges::unique(corners_);
    corners_.erase(surplus.begin(), surplus.end());
    parents_.resize(corners_.size());
    std::iota(parents_.begin(), parents_.end(), std::size_t{0});
    for (const RimEdge &rim : rims)
      parents_[setOf(rim.ends[0])] = setOf(rim.ends[1]);
  }

  std::size_t size() const { return corners_.size(); }

  /// The number of a set, below `size()`.
  std::size_t setOf(const Point64 &corner) {
    auto at = static_cast<std::size_t>(std::ranges::lower_bound(corners_, corner) - corners_.begin());
    while (parents_[at] != at)
      at = parents_[at] = parents_[parents_[at]];
    return at;
  }

private:
  std::vector<Point64> corners_;
  std::vector<std::size_t> parents_;
};

/// The mean of the points of a rim; within their box, whatever rounding does.
struct Middle {
  glm::dvec3 sum{};
  glm::dvec3 low{};
  glm::dvec3 high{};
  double count = 0;

  void add(const glm::dvec3 &point) {
    low = count == 0 ? point : glm::min(low, point);
    high = count == 0 ? point : glm::max(high, point);
    sum += point;
    ++count;
  }
  glm::dvec3 point() const { return glm::clamp(sum / count, low, high); }
};

} // namespace

HoleCaps HoleCaps::of(std::span<const RimEdge> rims, bool isEither, const MeshModel &model) {
  HoleCaps caps;
  const auto timesOf = [&](const RimEdge &rim) { return isEither ? rim.times % 2 : rim.times; };
  std::vector<RimEdge> open;
  std::uint64_t triangles = 0;
  for (const RimEdge &rim : rims)
    if (timesOf(rim) != 0) {
      open.push_back(rim);
      triangles += static_cast<std::uint64_t>(std::abs(timesOf(rim)));
    }
  if (triangles >= kMostTriangles) {
    caps.area = std::numeric_limits<double>::infinity();
    return caps;
  }
  RimCorners corners(open);
  std::vector<Middle> middles(corners.size());
  for (const RimEdge &rim : open)
    for (const glm::dvec3 &point : rim.points)
      middles[corners.setOf(rim.ends[0])].add(point);
  caps.holes = static_cast<std::uint64_t>(
      std::ranges::count_if(middles, [](const Middle &middle) { return middle.count > 0; }));
  for (const RimEdge &rim : open) {
    const std::int64_t times = timesOf(rim);
    const glm::dvec3 apex = middles[corners.setOf(rim.ends[0])].point();
    // The edge is passed back as often as it was passed.
    const glm::dvec3 &from = rim.points[times > 0 ? 1 : 0];
    const glm::dvec3 &to = rim.points[times > 0 ? 0 : 1];
    const ModelFrame &frame = model.grid.frame();
    const glm::dvec3 top = frame.toVoxels(apex);
    const double area = glm::length(glm::cross(frame.toVoxels(from) - top, frame.toVoxels(to) - top)) / 2;
    for (std::int64_t i = 0; i < std::abs(times); ++i) {
      for (const glm::dvec3 &corner : {from, to, apex})
        caps.corners.push_back({corner.x, corner.y, corner.z});
      caps.area += area;
    }
  }
  return caps;
}

} // namespace voxc
