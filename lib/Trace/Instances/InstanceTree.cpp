// A bounding-volume hierarchy over instances.
#include "InstanceTree.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace voxc {
namespace {

/// Four numbers that are computed with at once.
typedef float Float4 __attribute__((vector_size(16)));

Float4 loaded(const float (&values)[4]) { return Float4{values[0], values[1], values[2], values[3]}; }
Float4 larger(Float4 a, Float4 b) { return a > b ? a : b; }
Float4 smaller(Float4 a, Float4 b) { return a < b ? a : b; }

/// The cost of a split is looked at between so many slabs of the centres.
constexpr unsigned kBins = 16;
/// Deeper than this, halves are taken: no tree of at most 2^31 instances has more than 64 levels of two.
constexpr unsigned kDeepestBySurface = 32;

struct Bounds {
  glm::vec3 low{std::numeric_limits<float>::infinity()};
  glm::vec3 high{-std::numeric_limits<float>::infinity()};

  void grow(const glm::vec3 &l, const glm::vec3 &h) {
    low = glm::min(low, l);
    high = glm::max(high, h);
  }
  void grow(const Bounds &other) { grow(other.low, other.high); }
  /// Half of it; 0 where nothing is in it.
  float surface() const {
    const glm::vec3 e = high - low;
    return e.x >= 0 ? e.x * e.y + e.y * e.z + e.z * e.x : 0;
  }
};

using Numbers = std::span<std::uint32_t>;

class Builder {
public:
  using Node = InstanceTree::Node;

  Builder(std::span<const InstanceBox> boxes, std::vector<Node> &nodes) : boxes_(boxes), nodes_(nodes) {}

  /// Adds a node over these instances, at least one, of which there are `level` of two above.
  std::uint32_t build(Numbers numbers, unsigned level) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    levels = std::max(levels, level / 2 + 1);
    nodes_.push_back(emptyNode());
    std::array<Numbers, 4> parts{};
    unsigned count = 0;
    for (const Numbers half : split(numbers, level))
      for (const Numbers part : split(half, level + 1))
        if (!part.empty())
          parts[count++] = part;
    for (unsigned lane = 0; lane < count; ++lane) {
      const std::uint32_t child =
          parts[lane].size() == 1 ? parts[lane][0] | InstanceTree::kLeaf : build(parts[lane], level + 2);
      setLane(nodes_[index], lane, parts[lane], child);
    }
    return index;
  }

  std::uint32_t levels = 0; ///< Of nodes.

private:
  static Node emptyNode() {
    Node node{};
    std::ranges::fill(node.child, InstanceTree::kNone);
    return node;
  }

  glm::vec3 centreOf(std::uint32_t number) const {
    return boxes_[number].low * 0.5f + boxes_[number].high * 0.5f;
  }

  void setLane(Node &node, unsigned lane, Numbers numbers, std::uint32_t child) const {
    Bounds bounds;
    float slack = 0;
    for (const std::uint32_t number : numbers) {
      bounds.grow(boxes_[number].low, boxes_[number].high);
      slack = std::max(slack, boxes_[number].slack);
    }
    for (int axis = 0; axis < 3; ++axis) {
      node.low[axis][lane] = bounds.low[axis];
      node.high[axis][lane] = bounds.high[axis];
    }
    node.slack[lane] = slack;
    node.child[lane] = child;
  }

  /// Two parts, in place; the second is empty where there is but one instance.
  std::array<Numbers, 2> split(Numbers numbers, unsigned level) const {
    if (numbers.size() < 2)
      return {numbers, Numbers()};
    std::size_t first = level < kDeepestBySurface ? splitBySurface(numbers) : 0;
    if (first == 0 || first == numbers.size())
      first = splitInHalves(numbers);
    return {numbers.first(first), numbers.subspan(first)};
  }

  Bounds centresOf(Numbers numbers) const {
    Bounds centres;
    for (const std::uint32_t number : numbers)
      centres.grow(centreOf(number), centreOf(number));
    return centres;
  }

  static int longestAxisOf(const Bounds &bounds) {
    const glm::vec3 e = bounds.high - bounds.low;
    return e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
  }

  std::size_t splitInHalves(Numbers numbers) const {
    const int axis = longestAxisOf(centresOf(numbers));
    const std::size_t half = numbers.size() / 2;
    std::ranges::nth_element(numbers, numbers.begin() + static_cast<std::ptrdiff_t>(half),
                             [&](std::uint32_t a, std::uint32_t b) {
                               return std::pair(centreOf(a)[axis], a) < std::pair(centreOf(b)[axis], b);
                             });
    return half;
  }

  /// By the surface area heuristic over bins of centres along their longest axis (Wald 2007). 0: the centres
  /// are all one.
  std::size_t splitBySurface(Numbers numbers) const {
    const Bounds centres = centresOf(numbers);
    const int axis = longestAxisOf(centres);
    const float low = centres.low[axis], scale = kBins / (centres.high[axis] - low);
    if (!(scale > 0) || !std::isfinite(scale))
      return 0;
    const auto binOf = [&](std::uint32_t number) {
      return std::min(static_cast<unsigned>((centreOf(number)[axis] - low) * scale), kBins - 1);
    };
    std::array<Bounds, kBins> bins;
    std::array<std::size_t, kBins> counts{};
    for (const std::uint32_t number : numbers) {
      bins[binOf(number)].grow(boxes_[number].low, boxes_[number].high);
      ++counts[binOf(number)];
    }
    const unsigned best = cheapestSplit(bins, counts);
    const auto second = std::ranges::partition(numbers, [&](std::uint32_t n) { return binOf(n) < best; });
    return numbers.size() - second.size();
  }

  /// The first bin of the second part.
  static unsigned cheapestSplit(const std::array<Bounds, kBins> &bins,
                                const std::array<std::size_t, kBins> &counts) {
    std::array<float, kBins> costs{};
    Bounds before, behind;
    std::size_t countBefore = 0, countBehind = 0;
    for (unsigned bin = 1; bin < kBins; ++bin) {
      before.grow(bins[bin - 1]);
      countBefore += counts[bin - 1];
      costs[bin] += before.surface() * static_cast<float>(countBefore);
    }
    for (unsigned bin = kBins - 1; bin > 0; --bin) {
      behind.grow(bins[bin]);
      countBehind += counts[bin];
      costs[bin] += behind.surface() * static_cast<float>(countBehind);
    }
    return static_cast<unsigned>(std::min_element(costs.begin() + 1, costs.end()) - costs.begin());
  }

  std::span<const InstanceBox> boxes_;
  std::vector<Node> &nodes_;
};

} // namespace

InstanceTree::InstanceTree(std::span<const InstanceBox> boxes) {
  std::vector<std::uint32_t> numbers;
  Bounds all;
  for (std::uint32_t number = 0; number < boxes.size(); ++number) {
    (boxes[number].isEverywhere ? everywhere_ : numbers).push_back(number);
    if (boxes[number].isEverywhere)
      continue;
    all.grow(boxes[number].low, boxes[number].high);
    slack_ = std::max(slack_, boxes[number].slack);
    leastDirection_ = std::max(leastDirection_, boxes[number].leastDirection);
  }
  if (numbers.empty())
    return;
  low_ = all.low;
  high_ = all.high;
  Builder builder(boxes, nodes_);
  builder.build(numbers, 0);
  levels_ = builder.levels;
}

namespace {

/// A moment shortly before the ray, its direction scaled, comes to what it can hit: all boxes, and what their
/// slack is, lie in a ball. 0 where it begins there, or may hit instances that have no boxes. What is rounded
/// here is far less than the 2^-18 that it goes back.
float startOf(const glm::dvec3 &origin, const glm::dvec3 &direction, double reach, const InstanceTree &tree) {
  const glm::dvec3 low(tree.low()), high(tree.high());
  const double square = glm::dot(direction, direction);
  if (!tree.everywhere().empty() || !(square > 0))
    return 0;
  const double radius = glm::length(high - low) / 2 + 2 * reach * double{tree.slack()};
  const double middle = glm::dot((low + high) / 2.0 - origin, direction) / square;
  const double start = middle - std::abs(middle) * 0x1p-18 - radius * (1 + 0x1p-18) / std::sqrt(square);
  return static_cast<float>(std::clamp(start, 0.0, double{std::numeric_limits<float>::max()}));
}

} // namespace

BoxRay::BoxRay(const Ray &ray, const InstanceTree &tree) {
  const glm::dvec3 low(tree.low()), high(tree.high());
  const auto [x, y, z] = ray.direction;
  const float largest = std::max({std::abs(x), std::abs(y), std::abs(z)});
  std::frexp(largest, &exponent_);
  const glm::dvec3 from(ray.origin[0], ray.origin[1], ray.origin[2]);
  glm::dvec3 scaled;
  for (int axis = 0; axis < 3; ++axis)
    scaled[axis] = std::ldexp(ray.direction[axis], -exponent_);
  const double distance = glm::length(glm::max(glm::abs(low - from), glm::abs(high - from)));
  const bool isTiny = largest > 0 && largest < tree.leastDirection();
  reach = isTiny ? std::numeric_limits<float>::infinity() : static_cast<float>(distance * (1 + 0x1p-20));
  start_ = startOf(from, scaled, double{reach}, tree);
  const glm::dvec3 begin = from + scaled * double{start_};
  // A ray moves by less than 2^-99 of what it moves along its largest axis: far less than the slack of a box.
  constexpr double kNothing = 0x1p-100;
  double there = 0, coordinate = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto direction = static_cast<float>(scaled[axis]);
    origin[axis] = static_cast<float>(begin[axis]);
    falls[axis] = std::signbit(direction);
    inverse[axis] = std::abs(scaled[axis]) < kNothing
                        ? std::copysign(std::numeric_limits<float>::max(), direction)
                        : 1 / direction;
    there = std::max({there, std::abs(low[axis] - begin[axis]), std::abs(high[axis] - begin[axis])});
    coordinate = std::max({coordinate, std::abs(low[axis]), std::abs(high[axis])});
  }
  room = static_cast<float>((there + coordinate) / (1 << 20));
}

float BoxRay::momentOf(float t) const {
  return static_cast<float>(double{std::ldexp(t, exponent_)} - double{start_});
}

InstanceTree::Moments InstanceTree::momentsOf(const Node &node, const BoxRay &ray) {
  const Float4 slack = loaded(node.slack) * ray.reach + ray.room;
  Float4 near = {0, 0, 0, 0};
  Float4 far = near + std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const Float4 low = loaded(node.low[axis]) - slack - ray.origin[axis];
    const Float4 high = loaded(node.high[axis]) + slack - ray.origin[axis];
    near = larger(near, (ray.falls[axis] ? high : low) * ray.inverse[axis]);
    far = smaller(far, (ray.falls[axis] ? low : high) * ray.inverse[axis]);
  }
  Moments moments;
  for (int lane = 0; lane < 4; ++lane) {
    moments.near[lane] = near[lane];
    moments.far[lane] = far[lane];
  }
  return moments;
}

} // namespace voxc
