// The outlines of rectangles, with a corner wherever a neighbour has one.
#pragma once

#include "Source/Export/Faces.h"

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace voxc {

/// Corners of voxels, by bits in cubes of 8 a side.
class CornerSet {
public:
  void add(Int3 corner);
  bool contains(Int3 corner) const;

private:
  std::unordered_map<std::uint64_t, std::array<std::uint64_t, 8>> cubes_;
};

/// A corner of an outline: so many voxels along the width and the height of its rectangle.
struct OutlinePoint {
  std::uint8_t u = 0;
  std::uint8_t v = 0;
};

/// How an outline is cut into triangles.
struct Outline {
  /// Counter-clockwise as seen from outside. The first is the apex of a fan, or the last one, inside, is.
  std::vector<OutlinePoint> points;
  bool hasCentre = false;

  std::uint32_t triangles() const { return static_cast<std::uint32_t>(points.size()) - (hasCentre ? 1 : 2); }
};

/// The place of a point of a rectangle.
Int3 cornerOf(const FaceRectangle &face, OutlinePoint point);

/// Adds the four corners of a rectangle.
void addCorners(const FaceRectangle &face, CornerSet &corners);

/// Sets `outline` to that of a rectangle with all corners of the set that lie on it, so that triangles of
/// neighbours share whole edges and no ray passes between them.
void outlineOf(const FaceRectangle &face, const CornerSet &corners, Outline &outline);

} // namespace voxc
