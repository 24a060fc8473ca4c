// A kernel's interface as JSON.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Trace/Kernel.h"

#include <string>
#include <string_view>

namespace voxc::tool {

/// What `interfaceOf` says of the kernel of a format, and the facts that say which volumes and devices it is
/// for.
Expected<std::string> interfaceText(std::string_view format, const Kernel &kernel);

} // namespace voxc::tool
