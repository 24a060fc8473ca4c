// Which extensions of glTF are read, which may be passed over, and which not.
#pragma once

#include "Mesh/Gltf/GltfContext.h"

namespace voxc {

/// Problem: a required extension that a model cannot be read without. Warnings: others that are not known,
/// whether the file lists them or only has them.
void checkGltfExtensions(GltfContext &context);

} // namespace voxc
