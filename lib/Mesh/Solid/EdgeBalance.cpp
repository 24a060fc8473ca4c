// Sums of edges in buckets, where those of a closed mesh are 0; then the edges of the other buckets, one by
// one.
#include "Mesh/Solid/EdgeBalance.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace voxc {

namespace {

/// Buckets are so many that few of an open mesh's edges share one with an open edge.
constexpr std::uint64_t kFewestBuckets = 1 << 10;
constexpr std::uint64_t kMostBuckets = 1 << 24;
constexpr std::uint64_t kMostEdges = 1 << 22; ///< That are looked at one by one.
constexpr std::uint64_t kTrianglesBetweenLooks = 64;

/// What the edges of a bucket add up to.
struct Bucket {
  /// Of their hashes, those of edges that are passed backwards taken off: 0 if they even out.
  std::uint64_t sum = 0;
  /// Of their hashes by exclusive or: 0 if there is an even number of each.
  std::uint64_t parity = 0;
};

/// An edge of a triangle.
struct Edge {
  std::uint64_t hash; ///< Of its ends in order.
  /// 8 times the triangle, plus twice the edge's number there, plus 1 if it is passed backwards.
  std::uint64_t place;

  std::int64_t way() const { return (place & 1) == 0 ? 1 : -1; }
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
      : scene_(scene), model_(model), memory_(memory), progress_(progress), buckets_(memory) {}

  Expected<EdgeBalance> run() {
    const std::uint64_t buckets =
        std::bit_ceil(std::clamp(model_.numbers.size() / 2, kFewestBuckets, kMostBuckets));
    if (auto sized = buckets_.resize(buckets); !sized)
      return sized.error();
    auto summed = forEachEdge([&](const Edge &edge) -> Expected<void> {
      Bucket &bucket = bucketOf(edge);
      bucket.sum += edge.way() > 0 ? edge.hash : 0 - edge.hash;
      bucket.parity ^= edge.hash;
      return {};
    });
    if (!summed)
      return summed.error();
    EdgeBalance balance;
    if (std::ranges::all_of(buckets_.span(), [](const Bucket &bucket) { return bucket.sum == 0; }))
      return balance;
    const bool isEven =
        std::ranges::all_of(buckets_.span(), [](const Bucket &bucket) { return bucket.parity == 0; });
    balance.rule = isEven ? SolidRule::Parity : SolidRule::Enclosure;
    if (auto found = findOpen(balance.open); !found)
      return found.error();
    return balance;
  }

private:
  Bucket &bucketOf(const Edge &edge) { return buckets_[edge.hash & (buckets_.size() - 1)]; }

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
        const bool isBackwards = b < a;
        const Edge edge{isBackwards ? hashOf(b, a) : hashOf(a, b), 8 * number + 2 * from + isBackwards};
        if (auto visited = visit(edge); !visited)
          return visited;
      }
    }
    return {};
  }

  /// So many of the first buckets have about `kMostEdges` edges in those that are not even; one of these at
  /// least.
  std::uint64_t bucketsToOpen() const {
    const double edges = 3 * static_cast<double>(model_.numbers.size());
    const auto uneven = std::ranges::count_if(buckets_.span(), [](const Bucket &b) { return b.sum != 0; });
    const double share = static_cast<double>(kMostEdges) / edges * static_cast<double>(buckets_.size()) /
                         static_cast<double>(uneven);
    if (share >= 1)
      return buckets_.size();
    const auto end = static_cast<std::uint64_t>(share * static_cast<double>(buckets_.size()));
    const auto first = std::ranges::find_if(buckets_.span(), [](const Bucket &b) { return b.sum != 0; });
    return std::max(end, static_cast<std::uint64_t>(first - buckets_.span().begin()) + 1);
  }

  Expected<void> findOpen(OpenEdges &open) {
    const std::uint64_t end = bucketsToOpen();
    open.isAll = end == buckets_.size();
    ScratchArray<Edge> edges(memory_);
    auto collected = forEachEdge([&](const Edge &edge) -> Expected<void> {
      const bool isLeftOut = bucketOf(edge).sum == 0 || (edge.hash & (buckets_.size() - 1)) >= end;
      return isLeftOut ? Expected<void>() : edges.push(edge);
    });
    if (!collected)
      return collected;
    std::ranges::sort(edges.span(), {}, [](const Edge &edge) { return std::pair(edge.hash, edge.place); });
    std::uint64_t first = ~std::uint64_t{0};
    for (auto begin = edges.span().begin(); begin != edges.span().end();) {
      std::int64_t sum = 0;
      const auto group = begin;
      for (; begin != edges.span().end() && begin->hash == group->hash; ++begin)
        sum += begin->way();
      if (sum == 0)
        continue;
      ++open.count;
      first = std::min(first, group->place);
    }
    tellEnds(first, open);
    return {};
  }

  void tellEnds(std::uint64_t place, OpenEdges &open) const {
    TriangleCursor cursor(scene_, model_.numbers);
    cursor.moveTo(place / 8);
    const auto corners = cursor.corners();
    const std::uint64_t from = place / 2 % 4;
    for (int axis = 0; axis < 3; ++axis) {
      open.from[static_cast<std::size_t>(axis)] = corners[from][axis];
      open.to[static_cast<std::size_t>(axis)] = corners[(from + 1) % 3][axis];
    }
  }

  const TriangleScene &scene_;
  const MeshModel &model_;
  std::shared_ptr<WorkingMemory> memory_;
  const Progress &progress_;
  ScratchArray<Bucket> buckets_;
};

} // namespace

Expected<EdgeBalance> EdgeBalance::of(const TriangleScene &scene, const MeshModel &model,
                                      const std::shared_ptr<WorkingMemory> &memory,
                                      const Progress &progress) {
  return Counter(scene, model, memory, progress).run();
}

} // namespace voxc
