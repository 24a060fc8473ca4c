// What the readers of the parts of a glTF model share.
#pragma once

#include "Mesh/Gltf/GltfObject.h"
#include "Mesh/Gltf/GltfUris.h"
#include "Support/Warnings.h"
#include "voxc/Mesh/TriangleScene.h"

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>

namespace voxc {

struct GltfContext {
  GltfObject root;
  std::optional<std::span<const std::byte>> binary; ///< The chunk of a .glb.
  std::uint64_t fileBytes = 0;                      ///< Of the file itself.
  GltfUris uris;                                    ///< What is named beside the file.
  std::shared_ptr<WorkingMemory> memory;
  TriangleScene &scene;
  Warnings &warnings;
  Problem &problem;
  bool wantsMetal = false;                     ///< Textures of metal and roughness are read.
  std::set<std::string, std::less<>> unused{}; ///< What the model has that means nothing to voxels.
};

} // namespace voxc
