// The picture that stands on a page until a browser has made its own.
#pragma once

#include "voxc/Render/Picture.h"
#include "voxc/Support/Geometry.h"
#include "voxc/Trace/Camera.h"

#include <cstddef>
#include <string>

namespace voxc::page {

/// The element of a page of so many bytes, the poster apart, that shows `picture`, which `camera` has taken
/// of a volume of this extent, where the page will show its own: as large, in a window of any shape, with the
/// colours of its left edge around it; from inside it fills the window. It takes 12 kB, or a fiftieth of a
/// large page.
std::string posterHtml(const Picture &picture, const Camera &camera, Int3 extent, std::size_t pageBytes);

} // namespace voxc::page
