// Doing what waits to be done to a scene's volume, on the thread that paints it.
#pragma once

#include "view/Painting.h"
#include "view/Sculpture.h"

#include <cstdint>
#include <string>

namespace voxc::view {

/// What came of it.
struct Carving {
  bool isChanged = false;        ///< There is something new to be seen.
  int stamps = 0;                ///< Of strokes, that met a voxel.
  std::uint64_t copiedBytes = 0; ///< To the device.
  std::uint64_t voxels = 0;      ///< Of the volume now,
  std::uint64_t bytes = 0;       ///< and of the words of all its states.
};

/// Does all deeds of the shot's scene. Stamps go where the rays of their pixels hit what is to be seen before
/// any of them. Errors: a scene in pages, a format that cannot be edited, a colour that it cannot keep; those
/// of tracing.
Expected<Carving> carve(Scene &scene, const Shot &shot);

} // namespace voxc::view
