// One object with the same code for several processors, and code of its own that picks one.
#pragma once

#include "ClangFrontend.h"

#include "voxc/Support/Error.h"

#include <span>
#include <string>
#include <vector>

namespace voxc {

/// Compiles `files` as `compileToObject` does, once for each of the processors in place of
/// that of `options`, and once `dispatcher`, for
/// the baseline of this architecture, to one object. Whatever a variant defines has the processor's name
/// behind its own, as in "trace.x86_64_v3", and is called so by the dispatcher; what that defines is all that
/// can be seen from outside. So no variant shares a function with another, or with a program. Error: the
/// compiler's diagnostics.
Expected<std::string> compileVariants(const std::vector<MemoryFile> &files, const ClangOptions &options,
                                      std::span<const char *const> processors, const MemoryFile &dispatcher);

} // namespace voxc
