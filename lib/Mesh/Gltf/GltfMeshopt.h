// Buffer views that meshoptimizer compressed (EXT_meshopt_compression).
#pragma once

#include "Mesh/Gltf/GltfObject.h"
#include "voxc/Support/WorkingMemory.h"

#include <memory>
#include <span>

namespace voxc {

/// The extension of a buffer view, or nothing.
GltfObject meshoptOf(const GltfObject &view);

/// The bytes that a view's extension says it decodes to, none if they are more than `compressed` bytes can
/// hold, which is a problem.
std::uint64_t meshoptBytes(const GltfObject &meshopt, std::uint64_t compressed);

/// Decodes the bytes of a view. Nothing, with a problem, if they are broken or the extension makes no sense.
std::shared_ptr<const ScratchArray<std::byte>> decodeMeshopt(const GltfObject &meshopt,
                                                             std::span<const std::byte> compressed,
                                                             const std::shared_ptr<WorkingMemory> &memory,
                                                             Problem &problem);

} // namespace voxc
