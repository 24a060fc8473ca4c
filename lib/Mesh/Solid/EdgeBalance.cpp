// Sums of edges in buckets, where those of a closed mesh are 0; then the edges of the other buckets, one by
// one.
#include "Mesh/Solid/EdgeBalance.h"

#include "Mesh/Solid/PointHash.h"
#include "Mesh/Solid/RimLines.h"

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
constexpr std::uint64_t kMostRims = 1 << 18;  ///< That are kept.

/// What the edges of a bucket add up to.
struct Bucket {
  /// Of their hashes, those of edges that are passed backwards taken off: 0 if they even out.
  std::uint64_t sum = 0;
  /// Of their hashes by exclusive or: 0 if there is an even number of each.
  std::uint64_t parity = 0;
};

/// An edge of a triangle.
struct Edge {
  std::uint64_t hash;  ///< Of its ends in order.
  std::uint64_t place; ///< 16 times the triangle, plus 4 times the edge's number there, plus two bits.

  static constexpr std::uint64_t kIsBackwards = 1; ///< Its triangle passes it from the higher end.
  static constexpr std::uint64_t kIsMirrored = 2;  ///< So it counts the other way.

  std::uint64_t triangle() const { return place / 16; }
  std::size_t from() const { return place / 4 % 4; }
  bool isBackwards() const { return (place & kIsBackwards) != 0; }
  std::int64_t way() const { return isBackwards() == ((place & kIsMirrored) != 0) ? 1 : -1; }
};

class Counter {
public:
  Counter(const TriangleScene &scene, const MeshModel &model, const std::shared_ptr<WorkingMemory> &memory,
          const Progress &progress, const TriangleSet *only)
      : scene_(scene), model_(model), memory_(memory), progress_(progress), only_(only), buckets_(memory) {}

  Expected<EdgeBalance> run() {
    const std::uint64_t buckets =
        std::bit_ceil(std::clamp(model_.numbers.size() / 2, kFewestBuckets, kMostBuckets));
    VOXC_TRY(buckets_.resize(buckets));
    auto summed = forEachEdge([&](const Edge &edge) -> Expected<void> {
      Bucket &bucket = bucketOf(edge);
      bucket.sum += edge.way() > 0 ? edge.hash : 0 - edge.hash;
      bucket.parity ^= edge.hash;
      return {};
    });
    if (!summed)
      return summed.error();
    EdgeBalance balance;
    const bool isEven =
        std::ranges::all_of(buckets_.span(), [](const Bucket &bucket) { return bucket.parity == 0; });
    if (std::ranges::none_of(buckets_.span(), [this](const Bucket &bucket) { return isOpen(bucket); })) {
      balance.rule = only_ ? SolidRule::Parity : SolidRule::Winding;
      return balance;
    }
    balance.rule = isEven ? SolidRule::Parity : SolidRule::Enclosure;
    VOXC_TRY(findOpen(balance));
    return balance;
  }

private:
  Bucket &bucketOf(const Edge &edge) { return buckets_[edge.hash & (buckets_.size() - 1)]; }
  bool isOpen(const Bucket &bucket) const { return (only_ ? bucket.parity : bucket.sum) != 0; }

  /// Calls `visit` for the edges of all triangles, but for those without a length.
  template <typename Visit> Expected<void> forEachEdge(Visit visit) {
    const auto visitEdges = [&](std::uint64_t number, const TriangleCursor &cursor) -> Expected<void> {
      const SnappedTriangle triangle = model_.snapped(cursor);
      const std::uint64_t mirrored = cursor.isMirrored() ? Edge::kIsMirrored : 0;
      for (std::size_t from = 0; from < 3; ++from) {
        std::array<Point64, 2> ends{triangle.corners[from], triangle.corners[(from + 1) % 3]};
        if (ends[0] == ends[1])
          continue;
        const bool isBackwards = ends[1] < ends[0];
        if (isBackwards)
          std::swap(ends[0], ends[1]);
        const Edge edge{hashOf(ends), 16 * number + 4 * from + mirrored + isBackwards};
        VOXC_TRY(visit(edge));
      }
      return {};
    };
    return forEachTriangle(scene_, model_, only_, *memory_, progress_, visitEdges);
  }

  /// So many of the first buckets have about `kMostEdges` edges in those that are not even; one of these at
  /// least.
  std::uint64_t bucketsToOpen() const {
    const auto isOpenOne = [this](const Bucket &bucket) { return isOpen(bucket); };
    const double edges = 3 * static_cast<double>(model_.numbers.size());
    const auto uneven = std::ranges::count_if(buckets_.span(), isOpenOne);
    const double share = static_cast<double>(kMostEdges) / edges * static_cast<double>(buckets_.size()) /
                         static_cast<double>(uneven);
    if (share >= 1)
      return buckets_.size();
    const auto end = static_cast<std::uint64_t>(share * static_cast<double>(buckets_.size()));
    const auto first = std::ranges::find_if(buckets_.span(), isOpenOne);
    return std::max(end, static_cast<std::uint64_t>(first - buckets_.span().begin()) + 1);
  }

  Expected<void> findOpen(EdgeBalance &balance) {
    const std::uint64_t end = bucketsToOpen();
    balance.open.isAll = end == buckets_.size();
    ScratchArray<Edge> edges(memory_);
    auto collected = forEachEdge([&](const Edge &edge) -> Expected<void> {
      const bool isLeftOut = !isOpen(bucketOf(edge)) || (edge.hash & (buckets_.size() - 1)) >= end;
      return isLeftOut ? Expected<void>() : edges.push(edge);
    });
    if (!collected)
      return collected;
    std::ranges::sort(edges.span(), {}, [](const Edge &edge) { return std::pair(edge.hash, edge.place); });
    const Edge *first = nullptr;
    for (auto begin = edges.span().begin(); begin != edges.span().end();) {
      std::int64_t sum = 0;
      const Edge &group = *begin;
      std::int64_t count = 0;
      for (; begin != edges.span().end() && begin->hash == group.hash; ++begin, ++count)
        sum += begin->way();
      if (only_)
        sum = count % 2;
      if (sum == 0)
        continue;
      ++balance.open.count;
      if (!first || group.place < first->place)
        first = &group;
      if (balance.rims.size() < kMostRims)
        balance.rims.push_back(rimAt(group, sum));
    }
    balance.areRimsAll = balance.open.isAll && balance.open.count == balance.rims.size();
    if (balance.areRimsAll)
      join(balance);
    else if (first)
      tellEnds(rimAt(*first, 1), balance.open);
    return {};
  }

  /// Evens out rims that lie on each other, which may change the rule.
  void join(EdgeBalance &balance) const {
    balance.rims = joinedOnLines(balance.rims);
    if (only_)
      std::erase_if(balance.rims, [](const RimEdge &rim) { return rim.times % 2 == 0; });
    balance.open.count = balance.rims.size();
    if (balance.rims.empty()) {
      balance.rule = only_ ? SolidRule::Parity : SolidRule::Winding;
      return;
    }
    if (std::ranges::all_of(balance.rims, [](const RimEdge &rim) { return rim.times % 2 == 0; }))
      balance.rule = SolidRule::Parity;
    tellEnds(*std::ranges::min_element(balance.rims, {}, &RimEdge::place), balance.open);
  }

  RimEdge rimAt(const Edge &edge, std::int64_t times) const {
    TriangleCursor cursor(scene_, model_.numbers);
    cursor.moveTo(edge.triangle());
    const auto corners = cursor.corners();
    const SnappedTriangle snapped = model_.snapped(cursor);
    const std::size_t from = edge.from();
    const std::size_t to = (from + 1) % 3;
    const std::size_t low = edge.isBackwards() ? to : from;
    const std::size_t high = edge.isBackwards() ? from : to;
    return {{snapped.corners[low], snapped.corners[high]}, {corners[low], corners[high]}, times, edge.place};
  }

  static void tellEnds(const RimEdge &rim, OpenEdges &open) {
    for (int axis = 0; axis < 3; ++axis) {
      open.from[static_cast<std::size_t>(axis)] = rim.points[rim.times > 0 ? 0 : 1][axis];
      open.to[static_cast<std::size_t>(axis)] = rim.points[rim.times > 0 ? 1 : 0][axis];
    }
  }

  const TriangleScene &scene_;
  const MeshModel &model_;
  std::shared_ptr<WorkingMemory> memory_;
  const Progress &progress_;
  const TriangleSet *only_; ///< Then edges count whichever way they are passed.
  ScratchArray<Bucket> buckets_;
};

} // namespace

Expected<EdgeBalance> EdgeBalance::of(const TriangleScene &scene, const MeshModel &model,
                                      const std::shared_ptr<WorkingMemory> &memory,
                                      const Progress &progress) {
  return Counter(scene, model, memory, progress, nullptr).run();
}

Expected<EdgeBalance> EdgeBalance::ofEither(const TriangleSet &only, const TriangleScene &scene,
                                            const MeshModel &model,
                                            const std::shared_ptr<WorkingMemory> &memory,
                                            const Progress &progress) {
  return Counter(scene, model, memory, progress, &only).run();
}

} // namespace voxc
