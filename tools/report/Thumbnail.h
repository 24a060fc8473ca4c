// Pictures of models that lie inside the page.
#pragma once

#include "voxc/Support/Error.h"

#include <cstddef>
#include <string>

namespace voxc::report {

/// A picture file as a data: address of at most `mostBytes` characters, shrunk as far as that takes. Errors:
/// `Input` if it is no picture that can be read, or cannot be made so small.
Expected<std::string> thumbnail(const std::string &path, std::size_t mostBytes);

} // namespace voxc::report
