// Data that a URI holds itself, and the file names of other URIs.
#pragma once

#include "voxc/Support/WorkingMemory.h"

#include <string>
#include <string_view>

namespace voxc {

inline bool isDataUri(std::string_view uri) { return uri.starts_with("data:"); }

/// The bytes of a data URI. Errors: not in base 64, or broken; no memory.
Expected<ScratchArray<std::byte>> decodeDataUri(std::string_view uri, std::shared_ptr<WorkingMemory> memory);

/// A relative URI as a path: %20 and the like become characters.
std::string uriToPath(std::string_view uri);

} // namespace voxc
