// Pictures as files: PNG, JPEG or OpenEXR, as the name says.
#pragma once

#include "voxc/Render/Picture.h"
#include "voxc/Support/Error.h"

#include <span>
#include <string>

namespace voxc::tool {

/// The endings of picture files there are: ".png, .jpg, .jpeg or .exr".
std::string pictureEndings();

/// Whether `path` names a picture: it has one of these endings, in any case, or is "-", which is a PNG.
/// Error: `Usage`.
Expected<void> checkPictureName(const std::string &path);

/// Writes a picture in the kind that `path` says ("-": PNG on standard output), whole or not at all. `light`
/// has four numbers a pixel, linear and already exposed, for OpenEXR; without it the picture's own colours
/// are made linear. Errors: `Usage`, no such kind; `Environment`.
Expected<void> writePicture(const std::string &path, const Picture &picture,
                            std::span<const float> light = {});

} // namespace voxc::tool
