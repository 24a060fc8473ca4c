// The sign of a volume, modulo 2^128.
#include "Mesh/Solid/Facing.h"

#include "Mesh/Solid/HoleCaps.h"

#include <glm/geometric.hpp>

#include <array>
#include <vector>

namespace voxc {

namespace {

__extension__ using Uint128 = unsigned __int128;

/// Six times the volume of the tetrahedron of a triangle and the origin.
Uint128 volumeOf(const SnappedTriangle &triangle) {
  const auto &[a, b, c] = triangle.corners;
  const auto product = [](std::int64_t x, std::int64_t y, std::int64_t z) {
    // Below 2^120; sums that pass 2^128 on the way come back.
    return static_cast<Uint128>(x) * static_cast<Uint128>(y) * static_cast<Uint128>(z);
  };
  Uint128 volume = 0;
  for (std::size_t x = 0; x < 3; ++x) {
    const std::size_t y = (x + 1) % 3;
    const std::size_t z = (x + 2) % 3;
    volume += product(a[x], b[y], c[z]) - product(a[x], b[z], c[y]);
  }
  return volume;
}

/// That of triangles in model units.
Uint128 volumeOf(const std::vector<std::array<double, 3>> &corners, const SnapGrid &grid) {
  Uint128 volume = 0;
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    SnappedTriangle triangle;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto &[x, y, z] = corners[i + corner];
      triangle.corners[corner] = grid.snap({x, y, z});
    }
    volume += volumeOf(triangle);
  }
  return volume;
}

} // namespace

Expected<double> areaOf(const TriangleScene &scene, const MeshModel &model, const TriangleSet *only,
                        WorkingMemory &memory, const Progress &progress) {
  double area = 0;
  auto summed = forEachTriangle(scene, model, only, memory, progress,
                                [&](std::uint64_t, const TriangleCursor &cursor) -> Expected<void> {
                                  const auto [a, b, c] = model.inVoxels(model.snapped(cursor));
                                  area += glm::length(glm::cross(b - a, c - a)) / 2;
                                  return {};
                                });
  return summed ? Expected<double>(area) : summed.error();
}

Expected<Facing> facingOf(const TriangleScene &scene, const MeshModel &model,
                          const std::shared_ptr<WorkingMemory> &memory, const Progress &progress) {
  const auto balance = VOXC_TRY(EdgeBalance::of(scene, model, memory, progress));
  if (!balance.areRimsAll)
    return Facing::Unknown;
  const HoleCaps caps = HoleCaps::of(balance.rims, false, model);
  if (caps.holes != 0) {
    const auto area = VOXC_TRY(areaOf(scene, model, nullptr, *memory, progress));
    if (!caps.isSmall(area))
      return Facing::Unknown;
  }
  Uint128 volume = volumeOf(caps.corners, model.grid);
  auto summed = forEachTriangle(scene, model, nullptr, *memory, progress,
                                [&](std::uint64_t, const TriangleCursor &cursor) -> Expected<void> {
                                  const Uint128 part = volumeOf(model.snapped(cursor));
                                  volume += cursor.isMirrored() ? 0 - part : part;
                                  return {};
                                });
  if (!summed)
    return summed.error();
  if (volume == 0)
    return Facing::Unknown;
  return volume >> 127 == 0 ? Facing::Outwards : Facing::Inwards;
}

} // namespace voxc
