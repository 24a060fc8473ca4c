// The container of a glTF model: JSON alone, or a .glb with JSON and a binary chunk.
#pragma once

#include "voxc/Support/Error.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace voxc {

/// The parts of a file, in place.
struct GltfFile {
  std::span<const std::byte> json;
  std::optional<std::span<const std::byte>> binary;
  std::uint64_t others = 0; ///< Bytes of chunks of other kinds, and behind the last.
};

/// Finds the parts. Errors: a .glb of another version, or one that is cut short.
Expected<GltfFile> splitGltf(std::span<const std::byte> bytes);

} // namespace voxc
