// Walking along rims: whenever the way comes back to a corner, what lies between is a loop.
#include "Mesh/Solid/RimLoops.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstdlib>
#include <optional>

namespace voxc {

namespace {

using LoopList = std::vector<std::vector<LoopEdge>>;

constexpr std::uint64_t kMostEdges = 1 << 20;
constexpr std::size_t kMostChoices = 16; ///< At a corner, among which the next edge is chosen.

class Walk {
public:
  Walk(std::span<const RimEdge> rims, bool isEither) : isEither_(isEither) {
    for (const RimEdge &rim : rims)
      corners_.insert(corners_.end(), rim.ends.begin(), rim.ends.end());
    std::ranges::sort(corners_);
    const auto surplus = std::ranges::unique(corners_);
    corners_.erase(surplus.begin(), surplus.end());
    leaving_.resize(corners_.size());
    placeOnWay_.resize(corners_.size());
    for (const RimEdge &rim : rims)
      add(rim);
  }

  /// False if the way ends where no edge leads on.
  bool run(LoopList &loops) {
    for (std::size_t i = 0; i < edges_.size(); ++i)
      while (!edges_[i].isUsed)
        if (!followFrom(edges_[i].corners[0], loops))
          return false;
    return true;
  }

private:
  struct Edge {
    std::array<std::size_t, 2> corners;
    std::array<glm::dvec3, 2> points;
    bool isUsed = false;
  };

  /// An edge as it is passed; from its second corner, if it is turned.
  struct Step {
    std::size_t edge;
    bool isTurned;
  };

  void add(const RimEdge &rim) {
    const std::size_t low = numberOf(rim.ends[0]);
    const std::size_t high = numberOf(rim.ends[1]);
    const bool isBackwards = rim.times < 0;
    const std::int64_t times = isEither_ ? rim.times % 2 : rim.times;
    for (std::int64_t i = 0; i < std::abs(times); ++i) {
      const std::size_t from = isBackwards ? high : low;
      const std::size_t to = isBackwards ? low : high;
      leaving_[from].push_back({edges_.size(), false});
      if (isEither_)
        leaving_[to].push_back({edges_.size(), true});
      edges_.push_back({{from, to}, {rim.points[isBackwards ? 1 : 0], rim.points[isBackwards ? 0 : 1]}});
    }
  }

  std::size_t numberOf(const Point64 &corner) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(corners_, corner) - corners_.begin());
  }

  std::size_t endOf(const Step &step) const { return edges_[step.edge].corners[step.isTurned ? 0 : 1]; }
  LoopEdge passed(const Step &step) const {
    const auto &points = edges_[step.edge].points;
    return step.isTurned ? LoopEdge{points[1], points[0]} : LoopEdge{points[0], points[1]};
  }

  bool followFrom(std::size_t first, LoopList &loops) {
    std::size_t corner = first;
    placeOnWay_[first] = 0;
    do {
      const std::optional<Step> step = choose(corner);
      if (!step)
        return false;
      edges_[step->edge].isUsed = true;
      way_.push_back(*step);
      corner = endOf(*step);
      if (placeOnWay_[corner])
        takeLoop(*placeOnWay_[corner], loops);
      else
        placeOnWay_[corner] = way_.size();
    } while (!way_.empty());
    placeOnWay_[first].reset();
    return true;
  }

  /// What was walked since a place on the way.
  void takeLoop(std::size_t place, LoopList &loops) {
    std::vector<LoopEdge> &loop = loops.emplace_back();
    for (std::size_t i = place; i < way_.size(); ++i) {
      loop.push_back(passed(way_[i]));
      if (i + 1 < way_.size())
        placeOnWay_[endOf(way_[i])].reset();
    }
    way_.resize(place);
  }

  /// The next edge from a corner: one that comes back to the way, as soon as can be, else that which turns
  /// back most.
  std::optional<Step> choose(std::size_t corner) {
    std::vector<Step> &steps = leaving_[corner];
    while (!steps.empty() && edges_[steps.back().edge].isUsed)
      steps.pop_back();
    if (steps.empty())
      return std::nullopt;
    std::size_t best = steps.size() - 1;
    for (std::size_t i = steps.size() - std::min(steps.size(), kMostChoices); i < best; ++i)
      if (!edges_[steps[i].edge].isUsed && isBetter(steps[i], steps[best]))
        std::swap(steps[i], steps[best]);
    return steps[best];
  }

  bool isBetter(const Step &a, const Step &b) const {
    const std::optional<std::size_t> placeA = placeOnWay_[endOf(a)];
    const std::optional<std::size_t> placeB = placeOnWay_[endOf(b)];
    if (placeA || placeB || way_.empty())
      return placeA > placeB;
    const auto direction = [this](const Step &step) {
      const LoopEdge edge = passed(step);
      return glm::normalize(edge.to - edge.from);
    };
    const glm::dvec3 last = direction(way_.back());
    return glm::dot(direction(a), last) < glm::dot(direction(b), last);
  }

  bool isEither_;
  std::vector<Point64> corners_;
  std::vector<Edge> edges_;
  std::vector<std::vector<Step>> leaving_; ///< From each corner.
  std::vector<Step> way_;
  std::vector<std::optional<std::size_t>> placeOnWay_; ///< Of each corner: so many steps lead to it.
};

} // namespace

LoopList loopsOf(std::span<const RimEdge> rims, bool isEither) {
  std::uint64_t count = 0;
  for (const RimEdge &rim : rims)
    count += static_cast<std::uint64_t>(std::abs(isEither ? rim.times % 2 : rim.times));
  LoopList loops;
  if (count >= kMostEdges || !Walk(rims, isEither).run(loops))
    loops.clear();
  return loops;
}

} // namespace voxc
