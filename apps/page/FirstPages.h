// Which pages of a volume a picture looks at, so that a browser can ask for them before it has traced a ray.
#pragma once

#include "page/CheckRays.h"

#include "voxc/Support/Error.h"
#include "voxc/Trace/Clip.h"
#include "voxc/Volume/Volume.h"

#include <cstdint>
#include <vector>

namespace voxc::page {

/// Pages of `pageBytes` of the words that rays of the eye look at, through what `clip` keeps: in a picture of
/// few pixels first, then those that more pixels add; each step in order. Error: the kernel does not compile.
Expected<std::vector<std::uint32_t>> firstPages(const Volume &volume, const PictureView &view,
                                                const Clip &clip, std::uint32_t pageBytes);

} // namespace voxc::page
