// Files that were compiled into the library as text (cmake/VoxcEmbed.cmake), so that nothing must be found at
// run time.
#pragma once

#include <span>
#include <string_view>

namespace voxc {

struct EmbeddedFile {
  std::string_view path; ///< Below its folder: "level/raw.glsl".
  std::string_view text;
};

/// The files of shaders-runtime.
std::span<const EmbeddedFile> shaderFiles();

/// The headers of construct-runtime: what construct.cpp and edit.cpp include.
std::span<const EmbeddedFile> constructHeaders();

/// The leaves of cpu-runtime.
std::span<const EmbeddedFile> cpuFiles();

/// The headers of cpu-runtime: what intersect.cpp includes.
std::span<const EmbeddedFile> intersectHeaders();

} // namespace voxc
