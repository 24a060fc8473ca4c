// Rays whose hits a page knows, so that it can say whether the browser that shows it finds them.
#pragma once

#include "voxc/Support/Geometry.h"
#include "voxc/Trace/Camera.h"
#include "voxc/Trace/Ray.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace voxc::page {

/// The first so many rays of a sequence, from in and around a box of this extent to places in it: those that
/// page-runtime/script/rays.js makes too, to the bit.
std::vector<Ray> checkRays(Int3 extent, std::size_t count);

/// What a picture is of, in voxels and numbers of float32: from its middle, `front` far off, to its edges;
/// of an orthographic camera from the middle of the plane in which its rays begin.
struct PictureView {
  glm::dvec3 eye, front, right, up;
  bool isParallel = false; ///< All rays go `front`.
};

PictureView viewOf(const Camera &camera);

/// The ray through a place of the picture: (-1, -1) is the lower left corner, (1, 1) the opposite one.
Ray rayAt(const PictureView &view, double across, double above);

/// The first so many rays of a sequence through a picture, as page-runtime/script/rays.js makes them too, to
/// the bit.
std::vector<Ray> pictureRays(const PictureView &view, std::size_t count);

/// A byte for each hit, of its voxel and colour; as page-runtime/script/rays.js has it.
std::string digestsOf(std::span<const Hit> hits);

} // namespace voxc::page
