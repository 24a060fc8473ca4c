// Sorting edges, which tells of pairs of triangles, and then these pairs by their four corners.
#include "Mesh/Solid/TwinQuads.h"

#include "Mesh/Solid/PointHash.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace voxc {

namespace {

/// Of corners in any order: the sum of their hashes.
using CornerSum = std::uint64_t;

/// An edge of a triangle.
struct Side {
  CornerSum edge;
  CornerSum third;        ///< The corner that is not on it.
  std::uint64_t triangle; ///< Twice its number, plus 1 if it passes the edge from the greater hash.
};

/// Two triangles on both sides of an edge that no other one has.
struct Pair {
  CornerSum quad;
  CornerSum diagonal;
  std::array<std::uint64_t, 2> triangles;
};

class QuadFinder {
public:
  QuadFinder(const TriangleScene &scene, const MeshModel &model, const std::shared_ptr<WorkingMemory> &memory,
             const Progress &progress)
      : scene_(scene), model_(model), memory_(memory), progress_(progress), cursor_(scene, model.numbers),
        pairs_(memory) {}

  /// Errors: interrupted, no memory.
  Expected<bool> addTo(TriangleSet &twins) {
    VOXC_TRY(findPairs());
    std::ranges::sort(pairs_.span(), {},
                      [](const Pair &pair) { return std::tuple(pair.quad, pair.diagonal, pair.triangles); });
    bool hasAny = false;
    const std::span<Pair> pairs = pairs_.span();
    for (std::size_t begin = 0, end = 0; begin < pairs.size(); begin = end) {
      while (end < pairs.size() && pairs[end].quad == pairs[begin].quad)
        ++end;
      if (progress_.stopped())
        return Error::interrupted();
      const Pair *const side = sideOf(pairs.subspan(begin, end - begin));
      if (!side)
        continue;
      if (twins.empty() && !hasAny)
        VOXC_TRY(twins.resize(model_.numbers.size()));
      hasAny = true;
      for (const std::uint64_t triangle : side->triangles)
        twins.add(triangle);
    }
    return hasAny;
  }

private:
  Expected<ScratchArray<Side>> findSides() {
    ScratchArray<Side> sides(memory_);
    const auto add = [&](std::uint64_t number, const TriangleCursor &cursor) -> Expected<void> {
      const std::array<Point64, 3> corners = model_.snapped(cursor).corners;
      if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
        return {};
      std::array<std::uint64_t, 3> hashes;
      for (std::size_t i = 0; i < 3; ++i)
        hashes[i] = hashOf(std::span(&corners[i], 1));
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint64_t from = hashes[i], to = hashes[(i + 1) % 3];
        const bool isBack = (from > to) != cursor.isMirrored();
        VOXC_TRY(sides.push({from + to, hashes[(i + 2) % 3], 2 * number + isBack}));
      }
      return {};
    };
    auto visited = forEachTriangle(scene_, model_, nullptr, *memory_, progress_, add);
    return visited ? Expected<ScratchArray<Side>>(std::move(sides)) : visited.error();
  }

  Expected<void> findPairs() {
    auto found = VOXC_TRY(findSides());
    const std::span<Side> sides = found.span();
    std::ranges::sort(sides, {}, [](const Side &side) { return std::tuple(side.edge, side.triangle); });
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
      while (end < sides.size() && sides[end].edge == sides[begin].edge)
        ++end;
      const Side &a = sides[begin], &b = sides[end - 1];
      if (end - begin != 2 || ((a.triangle ^ b.triangle) & 1) == 0 || a.third == b.third)
        continue;
      if (auto added = pairs_.push({a.edge + a.third + b.third, a.edge, {a.triangle / 2, b.triangle / 2}});
          !added)
        return added;
    }
    return {};
  }

  /// Of pairs with the same corners one that has another behind it; null if there is none.
  const Pair *sideOf(std::span<const Pair> pairs) {
    for (std::size_t i = 0; i < pairs.size(); ++i)
      for (std::size_t j = i + 1; j < std::min(pairs.size(), i + kMostPairs); ++j)
        if (pairs[i].diagonal + pairs[j].diagonal == pairs[i].quad && areBackToBack(pairs[i], pairs[j]))
          return &pairs[i];
    return nullptr;
  }

  /// Whether each pair is nearly flat, and one looks away from the other.
  bool areBackToBack(const Pair &front, const Pair &back) {
    constexpr double kFlat = 0.9;
    const glm::dvec3 a = normalOf(front.triangles[0]), b = normalOf(front.triangles[1]);
    const glm::dvec3 c = normalOf(back.triangles[0]), d = normalOf(back.triangles[1]);
    return glm::dot(a, b) > kFlat && glm::dot(c, d) > kFlat && glm::dot(a + b, c + d) < -4 * kFlat;
  }

  /// Of length 1, or 0 if it has none.
  glm::dvec3 normalOf(std::uint64_t triangle) {
    cursor_.moveTo(triangle);
    const auto [a, b, c] = model_.inVoxels(model_.snapped(cursor_));
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    return length > 0 ? normal / (cursor_.isMirrored() ? -length : length) : glm::dvec3(0);
  }

  static constexpr std::size_t kMostPairs = 16; ///< Four corners have six edges.

  const TriangleScene &scene_;
  const MeshModel &model_;
  std::shared_ptr<WorkingMemory> memory_;
  const Progress &progress_;
  TriangleCursor cursor_;
  ScratchArray<Pair> pairs_;
};

} // namespace

Expected<bool> hasLittleVolume(const TriangleScene &scene, const MeshModel &model, WorkingMemory &memory,
                               const Progress &progress) {
  constexpr double kLittle = 0.03; // Quads that are not flat have a little between their sides.
  constexpr double kFar = std::numeric_limits<double>::max();
  glm::dvec3 low(kFar), high(-kFar);
  const glm::dvec3 middle = glm::dvec3(model.extent().x, model.extent().y, model.extent().z) / 2.0;
  double volume = 0;
  auto summed = forEachTriangle(scene, model, nullptr, memory, progress,
                                [&](std::uint64_t, const TriangleCursor &cursor) -> Expected<void> {
                                  const auto [a, b, c] = model.inVoxels(model.snapped(cursor));
                                  low = glm::min(low, glm::min(a, glm::min(b, c)));
                                  high = glm::max(high, glm::max(a, glm::max(b, c)));
                                  const double part =
                                      glm::dot(a - middle, glm::cross(b - middle, c - middle)) / 6;
                                  volume += cursor.isMirrored() ? -part : part;
                                  return {};
                                });
  if (!summed)
    return summed.error();
  const glm::dvec3 size = high - low;
  return std::abs(volume) <= kLittle * size.x * size.y * size.z;
}

Expected<bool> addTwinQuads(TriangleSet &twins, const TriangleScene &scene, const MeshModel &model,
                            const std::shared_ptr<WorkingMemory> &memory, const Progress &progress) {
  return QuadFinder(scene, model, memory, progress).addTo(twins);
}

} // namespace voxc
