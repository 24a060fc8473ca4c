// A fan from a corner has no triangle without an area if nothing lies on the two sides that meet there; else
// from a point inside.
#include "Source/Export/FaceOutline.h"

#include <algorithm>

namespace voxc {

namespace {

std::uint64_t cubeOf(Int3 corner) {
  constexpr int kBits = 21;
  const auto part = [](std::int32_t at) { return static_cast<std::uint64_t>(at >> 3); };
  return part(corner.x) | part(corner.y) << kBits | part(corner.z) << 2 * kBits;
}

std::uint64_t bitOf(Int3 corner) { return std::uint64_t{1} << ((corner.x & 7) + 8 * (corner.y & 7)); }

} // namespace

void CornerSet::add(Int3 corner) {
  cubes_[cubeOf(corner)][static_cast<std::size_t>(corner.z & 7)] |= bitOf(corner);
}

bool CornerSet::contains(Int3 corner) const {
  const auto cube = cubes_.find(cubeOf(corner));
  return cube != cubes_.end() && (cube->second[static_cast<std::size_t>(corner.z & 7)] & bitOf(corner)) != 0;
}

Int3 cornerOf(const FaceRectangle &face, OutlinePoint point) {
  Int3 corner = face.low;
  corner[face.axis] += face.isHigh;
  corner[(face.axis + 1) % 3] += point.u;
  corner[(face.axis + 2) % 3] += point.v;
  return corner;
}

void addCorners(const FaceRectangle &face, CornerSet &corners) {
  for (const int u : {0, face.width})
    for (const int v : {0, face.height})
      corners.add(cornerOf(face, {static_cast<std::uint8_t>(u), static_cast<std::uint8_t>(v)}));
}

void outlineOf(const FaceRectangle &face, const CornerSet &corners, Outline &outline) {
  // Counter-clockwise as seen against the axis: along the width, the height, and back.
  constexpr std::array<std::array<int, 2>, 4> kTurn{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  outline.points.clear();
  std::array<std::size_t, 5> begins{};
  int u = 0, v = 0;
  for (std::size_t side = 0; side < 4; ++side) {
    const auto [alongU, alongV] = kTurn[side];
    begins[side] = outline.points.size();
    const int length = alongU != 0 ? face.width : face.height;
    for (int i = 0; i < length; ++i, u += alongU, v += alongV) {
      const OutlinePoint point{static_cast<std::uint8_t>(u), static_cast<std::uint8_t>(v)};
      if (i == 0 || corners.contains(cornerOf(face, point)))
        outline.points.push_back(point);
    }
  }
  begins[4] = outline.points.size();
  const auto isPlain = [&](std::size_t side) { return begins[side + 1] - begins[side] == 1; };
  std::size_t apex = 0;
  while (apex < 4 && !(isPlain(apex) && isPlain((apex + 3) % 4)))
    ++apex;
  outline.hasCentre = apex == 4;
  if (!outline.hasCentre)
    std::ranges::rotate(outline.points, outline.points.begin() + static_cast<std::ptrdiff_t>(begins[apex]));
  if (!face.isHigh)
    std::reverse(outline.points.begin() + 1, outline.points.end());
  if (outline.hasCentre)
    outline.points.push_back({});
}

} // namespace voxc
