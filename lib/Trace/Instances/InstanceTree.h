// A bounding-volume hierarchy over instances: which of them a ray may hit, the nearest first.
#pragma once

#include "InstanceBoxes.h"

#include "voxc/Trace/BoundedRay.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace voxc {

/// A place in the order in which a ray comes to instances: by the moment at which it enters the box, on a
/// scale of its own, and of the same moment by number. Moments are bounds from below of those of hits.
struct InstanceKey {
  float moment = -1;
  std::uint32_t number = 0;

  friend auto operator<=>(const InstanceKey &, const InstanceKey &) = default;
};

class InstanceTree;

/// A ray of the world, made ready for tests of boxes: its direction is scaled by a power of two so that its
/// largest component is in [1/2, 1), and where it comes from outside it begins anew shortly before all that
/// it can hit. So float32 rounds by the size of the world, however far away the ray comes from. Moments of
/// the scaled ray overflow only where they mean nothing.
///
/// With v = 2^-23, one rounding whichever way it goes, C the largest coordinate of all boxes and D' the
/// distance by the largest axis from the new origin to the farthest corner of all: the new origin is rounded
/// by v (C + D'), the side of a box that has grown by v (C + 2 slack), its distance by v (D' + slack), and a
/// moment, of an inverse within 2.5 v and a product, by 3.5 v (D' + slack). So a box has to grow by less than
/// 7 v (C + D') more, which `room` is, and by 7 v of its slack, which is part of it (`InstanceBox`). What
/// float64 rounds of the new origin, 2^-52 of its way, is too.
class BoxRay {
public:
  BoxRay(const Ray &ray, const InstanceTree &tree);

  /// A moment of the ray as one of the scaled ray behind its new origin.
  float momentOf(float t) const;

  float origin[3];
  float inverse[3]; ///< Of the direction; the largest float32 with its sign where it is (nearly) 0.
  bool falls[3];
  float reach; ///< What a box's slack is multiplied with.
  float room;  ///< What a box grows by beside that.

private:
  int exponent_; ///< Of the direction's largest component.
  float start_;  ///< The moment of the new origin, of the scaled ray.
};

class InstanceTree {
public:
  /// Four boxes side by side, so that they are tested at once. The kernel's layout too
  /// (`shaders-runtime/instances/select.comp`).
  struct alignas(16) Node {
    float low[3][4], high[3][4];
    float slack[4];
    std::uint32_t child[4]; ///< A node's index, or an instance's number with `kLeaf`; `kNone`: no box.
  };
  static constexpr std::uint32_t kLeaf = std::uint32_t{1} << 31;
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  /// No traversal of any tree has more nodes on its stack: three siblings a level, of at most 32 levels.
  static constexpr std::size_t kMostStacked = 100;

  explicit InstanceTree(std::span<const InstanceBox> boxes);

  /// The first is the root; none: there are no boxes.
  std::span<const Node> nodes() const { return nodes_; }
  /// The most nodes on the stack of a traversal of this tree.
  std::uint32_t mostStacked() const { return 3 * levels_ + 1; }
  /// Instances that any ray may hit.
  std::span<const std::uint32_t> everywhere() const { return everywhere_; }
  const glm::vec3 &low() const { return low_; }
  const glm::vec3 &high() const { return high_; }
  /// The most of all.
  float slack() const { return slack_; }
  /// Rays whose direction has no component as large may hit any of them.
  float leastDirection() const { return leastDirection_; }

  /// Calls visit(key, limit) for instances behind `after` that the ray may hit between its bounds, and maybe
  /// some of those before; `limit` is a moment beyond which none needs to be visited any more, which `visit`
  /// may lower. Not in the order of their keys, but no instance whose key is not above `limit` is left out.
  template <typename Visit>
  void traverse(const BoxRay &ray, const RayBounds &bounds, const InstanceKey &after, float limit,
                Visit &visit) const;

private:
  struct Entry {
    float near;
    std::uint32_t node;
  };
  using Stack = std::array<Entry, kMostStacked>;

  /// The moments at which a ray enters and leaves the four boxes; it misses those that it leaves first.
  struct Moments {
    float near[4], far[4];
  };
  static Moments momentsOf(const Node &node, const BoxRay &ray);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> everywhere_;
  glm::vec3 low_{0}, high_{0};
  float slack_ = 0;
  float leastDirection_ = 0;
  std::uint32_t levels_ = 0; ///< Of nodes.
};

/// Moments by float32 are off by less than this, of them.
inline constexpr float kMomentRounding = 1.0f / (1 << 20);

template <typename Visit>
void InstanceTree::traverse(const BoxRay &ray, const RayBounds &bounds, const InstanceKey &after, float limit,
                            Visit &visit) const {
  for (const std::uint32_t number : everywhere_)
    if (const InstanceKey key{0, number}; key > after && key.moment <= limit)
      visit(key, limit);
  if (nodes_.empty())
    return;
  const float tmin = ray.momentOf(bounds.tmin), tmax = ray.momentOf(bounds.tmax);
  Stack stack;
  std::size_t depth = 0;
  stack[depth++] = {0, 0};
  while (depth > 0) {
    const Entry entry = stack[--depth];
    if (entry.near > limit)
      continue;
    const Node &node = nodes_[entry.node];
    const Moments moments = momentsOf(node, ray);
    const std::size_t bottom = depth;
    for (unsigned lane = 0; lane < 4 && node.child[lane] != kNone; ++lane) {
      const float near = moments.near[lane], far = moments.far[lane];
      const float late = far + far * kMomentRounding;
      if (!(near <= late) || near > limit || late < tmin || near - near * kMomentRounding > tmax ||
          late < after.moment)
        continue;
      if (node.child[lane] & kLeaf) {
        if (const InstanceKey key{near, node.child[lane] & ~kLeaf}; key > after)
          visit(key, limit);
        continue;
      }
      // The nearest comes to lie on top.
      std::size_t place = depth++;
      for (; place > bottom && stack[place - 1].near < near; --place)
        stack[place] = stack[place - 1];
      stack[place] = {near, node.child[lane]};
    }
  }
}

} // namespace voxc
