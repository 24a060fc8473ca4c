// Where the tools keep what another run can use: speeds of devices, compiled code.
#pragma once

#include "voxc/Support/CompileCache.h"

#include <filesystem>
#include <string>

namespace voxc {

/// The folder "voxc" of the user's cache: of $XDG_CACHE_HOME, else of ~/.cache; empty without a home.
std::filesystem::path userCache();

/// The folder of compiled code: $VOXC_CACHE, else "compiled" in `userCache`; empty where there is none, or
/// VOXC_CACHE is "off".
std::string compileCacheFolder();

/// The cache of compiled code; null where there is none that can be used. Opened when it is first asked for.
const CompileCache *compileCache();

} // namespace voxc
