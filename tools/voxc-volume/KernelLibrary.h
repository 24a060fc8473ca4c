// Kernels of `voxc compile --emit=cpu` that were linked to libraries.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Trace/CpuKernel.h"

#include <string>

namespace voxc::tool {

/// Loads a library that has the function `voxc_intersect`, and `voxc_intersect_storage`, a 64-bit number: the
/// digest of the storage that it fits. Trusts its code. Errors: no library, or without one of these
/// (`Input`).
Expected<CpuKernel> loadKernel(const std::string &path);

} // namespace voxc::tool
