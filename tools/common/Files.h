// Files as the tools read and write them: whole, little-endian, and never half-written. "-" is standard input or
// output.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Trace/Ray.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voxc::tool {

/// The whole file as text. Errors: `Input` if there is none or it cannot be read.
Expected<std::string> readText(const std::string &path);

/// Writes a file under a temporary name beside it and renames it: `path` is whole, or as it was.
/// Errors: `Environment` if it cannot be created, written or renamed.
Expected<void> writeBytes(const std::string &path, std::span<const std::byte> bytes);
Expected<void> writeText(const std::string &path, std::string_view text);

/// A ray file: 24 bytes a ray. Errors: unreadable, or not a multiple of 24 bytes (`Input`).
Expected<std::vector<Ray>> readRays(const std::string &path);

/// A hit file: 24 bytes a hit.
Expected<void> writeHits(const std::string &path, std::span<const Hit> hits);

} // namespace voxc::tool
