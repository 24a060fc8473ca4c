// Pictures made small enough to lie inside the page.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Trace/Picture.h"

#include <cstddef>
#include <string>

namespace voxc::report {

/// The picture at most `width` pixels wide, each the mean of those that it covers.
Picture shrunk(const Picture &picture, int width);

/// A picture file as a data: address of at most `mostBytes` characters, shrunk as far as that takes. Errors:
/// `Input` if it is no picture that can be read, or cannot be made so small.
Expected<std::string> thumbnail(const std::string &path, std::size_t mostBytes);

} // namespace voxc::report
