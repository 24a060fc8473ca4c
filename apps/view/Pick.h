// What a click tells: the ray through a pixel, and what it hits.
#pragma once

#include "view/Painting.h"

#include <string>

namespace voxc::view {

struct Pick {
  Shot shot;
  BoundedRay ray;
  Hit hit;
};

/// Traces the ray through the middle of a pixel of `shot`, which must lie in its picture. Errors: those of
/// tracing.
Expected<Pick> pick(const Shot &shot, int column, int row);

/// A hit in words: "voxel 12,3,40, colour #80c0ff, t 17.25"; "no voxel" of a miss.
std::string describe(const Hit &hit);

} // namespace voxc::view
