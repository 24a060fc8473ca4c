// Rays through the boxes of coarse blocks.
//
// Boxes and the cubes above them are taken a little larger than they are. What is computed of a ray is off by
// far less than that, as long as it begins near the volume: so no ray passes by a box that has a voxel of its
// way, not even one that goes exactly through an edge.
#include "CoarseStandIn.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace voxc {
namespace {

constexpr double kSlack = 1.0 / 1024;
/// Origins further off than that are left to the kernel.
constexpr float kMostOrigin = 1 << 24;

/// From one t to another.
struct Interval {
  double first = 0;
  double last = 0;
};

/// Where a ray is in a box of voxels, from `low` to `high`, before t = 0 too.
std::optional<Interval> crossing(const Ray &ray, const CoarseBox &box, double slack) {
  Interval inside = {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (int axis = 0; axis < 3; ++axis) {
    const double origin = ray.origin[axis], direction = ray.direction[axis];
    const double low = box.low[axis] - slack, high = box.high[axis] + 1 + slack;
    if (direction == 0) {
      if (origin < low || origin > high)
        return std::nullopt;
      continue;
    }
    const double a = (low - origin) / direction, b = (high - origin) / direction;
    inside.first = std::max(inside.first, std::min(a, b));
    inside.last = std::min(inside.last, std::max(a, b));
  }
  if (inside.first > inside.last)
    return std::nullopt;
  return inside;
}

bool isNear(const Ray &ray) {
  bool moves = false;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(std::abs(ray.origin[axis]) < kMostOrigin) || !std::isfinite(ray.direction[axis]))
      return false;
    moves |= ray.direction[axis] != 0;
  }
  return moves;
}

/// One ray's way down the tree.
class StandInTraversal {
public:
  StandInTraversal(const CoarseTree &tree, const Ray &ray, double entry, const CoarseView &view)
      : tree_(tree), ray_(ray), entry_(entry), view_(view) {
    for (int axis = 0; axis < 3; ++axis)
      nearest_ |= ray.direction[axis] < 0 ? 1u << axis : 0u;
  }

  CoarseStandIn::Answer run() {
    if (!tree_.empty())
      visit(tree_.layers(), 0, {});
    if (ended_)
      return answer_;
    using enum CoarseStandIn::Outcome;
    return {passed_ ? Answered : Misses, {{-1, -1, -1}, 0, 0, 0}, 0};
  }

private:
  bool isAhead(const std::optional<Interval> &inside) const { return inside && inside->last >= entry_; }

  /// The children of a node that lies at `low`, counted in blocks, from the nearest.
  void visit(int layer, std::uint32_t index, Int3 low) {
    const CoarseTree::Node &node = tree_.node(layer, index);
    const std::int32_t blocks = 1 << (layer - 1);
    const std::int32_t voxels = blocks << tree_.log2Side();
    for (unsigned turn = 0; turn < 8 && !ended_; ++turn) {
      const unsigned octant = turn ^ nearest_;
      if ((node.octants >> octant & 1) == 0)
        continue;
      const Int3 child = low + mortonCell(octant) * blocks;
      const Int3 corner = child * (1 << tree_.log2Side());
      const Int3 last = corner + Int3{voxels - 1, voxels - 1, voxels - 1};
      if (!isAhead(crossing(ray_, {corner, last}, kSlack)))
        continue;
      if (layer == 1)
        meet(tree_.block(node.child(octant)), corner);
      else
        visit(layer - 1, node.child(octant), child);
    }
  }

  /// A block at `corner`, in voxels.
  void meet(const CoarseTree::Block &block, Int3 corner) {
    CoarseBox box = unpackBox(block.box);
    box = {corner + box.low, corner + box.high};
    const auto inside = crossing(ray_, box, kSlack);
    if (!isAhead(inside))
      return;
    if (!looksSmall(std::max(inside->first, entry_))) {
      answer_ = {CoarseStandIn::Outcome::Waits, {}, static_cast<float>(inside->last)};
      ended_ = true;
    } else if (inside->first <= 0) {
      passed_ = true; // A ray from a surface would always find the box of that.
    } else {
      answer_ = {CoarseStandIn::Outcome::Answered, hitOf(box, *inside, block.rgba), 0};
      ended_ = true;
    }
  }

  bool looksSmall(double t) const {
    double square = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double away = ray_.origin[axis] + t * ray_.direction[axis] - view_.from[axis];
      square += away * away;
    }
    return (1 << tree_.log2Side()) < view_.spread * std::sqrt(square);
  }

  /// Where the ray comes into the box, or where it waits in it. One that passes right by it is taken to
  /// touch.
  Hit hitOf(const CoarseBox &box, const Interval &around, std::uint32_t rgba) const {
    const double t = std::max(crossing(ray_, box, 0).value_or(around).first, entry_);
    Hit hit = {{}, rgba, static_cast<float>(t), 0};
    for (int axis = 0; axis < 3; ++axis) {
      const double place = ray_.origin[axis] + t * ray_.direction[axis];
      const double voxel = ray_.direction[axis] < 0 ? std::ceil(place) - 1 : std::floor(place);
      hit.voxel[axis] = static_cast<std::int32_t>(std::clamp<double>(voxel, box.low[axis], box.high[axis]));
    }
    return hit;
  }

  const CoarseTree &tree_;
  const Ray &ray_;
  double entry_;
  const CoarseView &view_;
  unsigned nearest_ = 0; ///< The octant of a node that the ray comes to first.
  bool passed_ = false;  ///< It began in a box that looks small.
  bool ended_ = false;
  CoarseStandIn::Answer answer_;
};

} // namespace

double CoarseStandIn::entryOf(const Ray &ray, Int3 cell) {
  double entry = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double direction = ray.direction[axis];
    if (direction != 0)
      entry = std::max(entry, (cell[axis] + (direction < 0 ? 1.0 : 0.0) - ray.origin[axis]) / direction);
  }
  return entry;
}

CoarseStandIn::Answer CoarseStandIn::answer(const Ray &ray, double entry, const CoarseView &view) const {
  if (!isNear(ray))
    return {.outcome = Outcome::Waits, .hit = {}, .until = std::numeric_limits<float>::infinity()};
  return StandInTraversal(tree_, ray, entry, view).run();
}

} // namespace voxc
