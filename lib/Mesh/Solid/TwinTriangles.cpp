// Counting triangles in buckets, which tell of most that they are alone; then the others, one by one.
#include "Mesh/Solid/TwinTriangles.h"

#include "Mesh/Solid/PointHash.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>

namespace voxc {

namespace {

constexpr std::uint64_t kFewestBuckets = 1 << 10;
constexpr std::uint64_t kMostBuckets = 1 << 24;

struct Bucket {
  std::uint64_t sum = 0; ///< Of hashes, those of triangles that turn the other way taken off.
  std::uint64_t count = 0;

  /// Two with other corners do not even out; of more, who knows.
  bool mayHaveTwins() const { return count > 2 || (count == 2 && sum == 0); }
};

/// A triangle by its corners in order.
struct Sorted {
  std::uint64_t hash;
  std::uint64_t place; ///< Twice its number, plus 1 if sorting turned it around.

  std::int64_t way() const { return (place & 1) == 0 ? 1 : -1; }
};

/// Nothing for triangles of which two corners are in one place.
std::optional<Sorted> sortedOf(const MeshModel &model, std::uint64_t number, const TriangleCursor &cursor) {
  std::array<Point64, 3> corners = model.snapped(cursor).corners;
  bool isTurned = cursor.isMirrored();
  const auto order = [&](std::size_t a, std::size_t b) {
    if (!(corners[b] < corners[a]))
      return;
    std::swap(corners[a], corners[b]);
    isTurned = !isTurned;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  if (corners[0] == corners[1] || corners[1] == corners[2])
    return std::nullopt;
  return Sorted{hashOf(corners), 2 * number + isTurned};
}

} // namespace

Expected<TriangleSet> findTwins(const TriangleScene &scene, const MeshModel &model,
                                const std::shared_ptr<WorkingMemory> &memory, const Progress &progress) {
  ScratchArray<Bucket> buckets(memory);
  const std::uint64_t size = std::bit_ceil(std::clamp(model.numbers.size(), kFewestBuckets, kMostBuckets));
  VOXC_TRY(buckets.resize(size));
  const auto bucketOf = [&](const Sorted &triangle) -> Bucket & {
    return buckets[triangle.hash & (size - 1)];
  };
  const auto forEach = [&](auto visit) {
    return forEachTriangle(scene, model, nullptr, *memory, progress,
                           [&](std::uint64_t number, const TriangleCursor &cursor) -> Expected<void> {
                             const auto triangle = sortedOf(model, number, cursor);
                             return triangle ? visit(*triangle) : Expected<void>();
                           });
  };
  auto counted = forEach([&](const Sorted &triangle) -> Expected<void> {
    Bucket &bucket = bucketOf(triangle);
    bucket.sum += triangle.way() > 0 ? triangle.hash : 0 - triangle.hash;
    ++bucket.count;
    return {};
  });
  if (!counted)
    return counted.error();
  TriangleSet twins(memory);
  ScratchArray<Sorted> triangles(memory);
  if (std::ranges::any_of(buckets.span(), &Bucket::mayHaveTwins)) {
    auto collected = forEach([&](const Sorted &triangle) {
      return bucketOf(triangle).mayHaveTwins() ? triangles.push(triangle) : Expected<void>();
    });
    if (!collected)
      return collected.error();
  }
  std::ranges::sort(triangles.span(), {}, [](const Sorted &t) { return std::pair(t.hash, t.place); });
  for (auto begin = triangles.span().begin(); begin != triangles.span().end();) {
    const Sorted &first = *begin;
    std::int64_t sum = 0;
    for (; begin != triangles.span().end() && begin->hash == first.hash; ++begin)
      sum += begin->way();
    if (sum != 0)
      continue;
    if (twins.empty())
      VOXC_TRY(twins.resize(model.numbers.size()));
    twins.add(first.place / 2);
  }
  return twins;
}

} // namespace voxc
