// Sums of edges in buckets, where those of a closed mesh are 0; then the edges of the other buckets, one by
// one.
#include "Mesh/Solid/EdgeBalance.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace voxc {

namespace {

constexpr int kLog2Buckets = 14;
constexpr std::uint64_t kTrianglesBetweenLooks = 64;

/// What the edges of a bucket add up to.
struct Bucket {
  std::uint64_t sum =
      0; ///< Of their hashes, those that are passed the other way taken off: 0 if they are even.
  std::uint64_t parity = 0; ///< Their hashes, one over the other by exclusive or: 0 if there are two of each.
};

/// An edge, passed one way (1) or the other (-1).
struct Edge {
  std::uint64_t hash; ///< Of its ends in order.
  std::int64_t way;
  std::uint64_t number; ///< 4 times its triangle, and which of the triangle's edges.
};

constexpr std::uint64_t scattered(std::uint64_t value) {
  value = (value ^ value >> 32) * 0xd6e8feb86659fd93;
  value = (value ^ value >> 32) * 0xd6e8feb86659fd93;
  return value ^ value >> 32;
}

std::uint64_t hashOf(const Point64 &low, const Point64 &high) {
  std::uint64_t hash = 0;
  for (const Point64 *point : {&low, &high})
    for (const std::int64_t coordinate : *point)
      hash = scattered(hash * 0x9e3779b97f4a7c15 + static_cast<std::uint64_t>(coordinate));
  return hash;
}

class Counter {
public:
  Counter(const TriangleScene &scene, const MeshModel &model, const std::shared_ptr<WorkingMemory> &memory,
          const Progress &progress)
      : scene_(scene), model_(model), memory_(memory), progress_(progress),
        buckets_(std::size_t{1} << kLog2Buckets) {}

  Expected<EdgeBalance> run() {
    auto summed = forEachEdge([&](const Edge &edge) -> Expected<void> {
      Bucket &bucket = buckets_[edge.hash >> (64 - kLog2Buckets)];
      bucket.sum += edge.way > 0 ? edge.hash : 0 - edge.hash;
      bucket.parity ^= edge.hash;
      return {};
    });
    if (!summed)
      return summed.error();
    EdgeBalance balance;
    if (std::ranges::all_of(buckets_, [](const Bucket &bucket) { return bucket.sum == 0; }))
      return balance;
    const bool isEven =
        std::ranges::all_of(buckets_, [](const Bucket &bucket) { return bucket.parity == 0; });
    balance.rule = isEven ? SolidRule::Parity : SolidRule::Enclosure;
    if (auto found = findOpen(balance.open); !found)
      return found.error();
    return balance;
  }

private:
  /// Calls `visit` for the edges of all triangles, but for those without a length.
  template <typename Visit> Expected<void> forEachEdge(Visit visit) {
    TriangleCursor cursor(scene_, model_.numbers);
    for (std::uint64_t number = 0; number < model_.numbers.size(); ++number) {
      if (number % kTrianglesBetweenLooks == 0) {
        if (progress_.stopped())
          return Error::interrupted();
        memory_->relieve();
      }
      cursor.moveTo(number);
      const SnappedTriangle triangle = model_.snapped(cursor);
      for (std::size_t from = 0; from < 3; ++from) {
        const Point64 &a = triangle.corners[from];
        const Point64 &b = triangle.corners[(from + 1) % 3];
        if (a == b)
          continue;
        const Edge edge{a < b ? hashOf(a, b) : hashOf(b, a), a < b ? 1 : -1, 4 * number + from};
        if (auto visited = visit(edge); !visited)
          return visited;
      }
    }
    return {};
  }

  Expected<void> findOpen(OpenEdges &open) {
    ScratchArray<Edge> edges(memory_);
    auto collected = forEachEdge([&](const Edge &edge) -> Expected<void> {
      const bool isEven = buckets_[edge.hash >> (64 - kLog2Buckets)].sum == 0;
      return isEven ? Expected<void>() : edges.push(edge);
    });
    if (!collected)
      return collected;
    std::ranges::sort(edges.span(), {}, [](const Edge &edge) { return std::pair(edge.hash, edge.number); });
    std::uint64_t first = ~std::uint64_t{0};
    for (auto begin = edges.span().begin(); begin != edges.span().end();) {
      std::int64_t sum = 0;
      const auto group = begin;
      for (; begin != edges.span().end() && begin->hash == group->hash; ++begin)
        sum += begin->way;
      if (sum == 0)
        continue;
      ++open.count;
      first = std::min(first, group->number);
    }
    place(first, open);
    return {};
  }

  void place(std::uint64_t edge, OpenEdges &open) const {
    TriangleCursor cursor(scene_, model_.numbers);
    cursor.moveTo(edge / 4);
    const auto ends = cursor.corners();
    for (int axis = 0; axis < 3; ++axis) {
      open.from[static_cast<std::size_t>(axis)] = ends[edge % 4][axis];
      open.to[static_cast<std::size_t>(axis)] = ends[(edge % 4 + 1) % 3][axis];
    }
  }

  const TriangleScene &scene_;
  const MeshModel &model_;
  std::shared_ptr<WorkingMemory> memory_;
  const Progress &progress_;
  std::vector<Bucket> buckets_;
};

} // namespace

Expected<EdgeBalance> EdgeBalance::of(const TriangleScene &scene, const MeshModel &model,
                                      const std::shared_ptr<WorkingMemory> &memory,
                                      const Progress &progress) {
  return Counter(scene, model, memory, progress).run();
}

} // namespace voxc
