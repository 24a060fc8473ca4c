// Files of the tools: rays and hits, and outputs. "-" is standard input or output.
#pragma once

#include "RayFile.h"

#include "voxc/Support/Error.h"
#include "voxc/Trace/Ray.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voxc::tool {

/// Whether a path ends so, such as ".hvx", in letters of any case.
bool hasEnding(std::string_view path, std::string_view ending);

/// Writes a whole file, or nothing: `path` is whole, or unchanged. Errors: `Environment` if it cannot be
/// written.
Expected<void> writeBytes(const std::string &path, std::span<const std::byte> bytes);
Expected<void> writeText(const std::string &path, std::string_view text);

/// Hands on what was written to standard output. Where its reader has gone, as `head` does, the process ends
/// by SIGPIPE, without a word. Error: `Environment`, with the reason if that is known.
Expected<void> flushStandardOutput();

/// A ray file of either version. Errors: unreadable, or as of `parseRayFile`.
Expected<RayFile> readRayFile(const std::string &path);

/// The rays of a file, where they have no bounds. Errors: as of `readRayFile`; `Input` if they have some.
Expected<std::vector<Ray>> readRays(const std::string &path);

/// The hits of a file of version 1, 24 bytes each. Errors: `Input` if it is unreadable or no multiple of 24
/// bytes.
Expected<std::vector<Hit>> readHits(const std::string &path);

/// A hit file of version 1: 24 bytes a hit. Errors as `writeBytes`.
Expected<void> writeHits(const std::string &path, std::span<const Hit> hits);

} // namespace voxc::tool
