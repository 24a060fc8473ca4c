// Materials of a glTF model, those that are used.
#pragma once

#include "Mesh/Gltf/GltfBuffers.h"
#include "Mesh/TextureSet.h"

#include <optional>
#include <vector>

namespace voxc {

class GltfMaterials {
public:
  GltfMaterials(GltfContext &context, GltfBuffers &buffers);

  struct Use {
    std::uint32_t material = 0;      ///< Index into the scene's materials.
    std::uint64_t uvSet = 0;         ///< The texture coordinates that its texture takes,
    std::uint64_t emissionUvSet = 0; ///< that of its emission,
    std::uint64_t metalUvSet = 0;    ///< and that of metal and roughness.
  };

  /// The material of a primitive.
  Use use(const GltfObject &primitive);

  std::uint64_t libraryPeakBytes() const { return textures_.libraryPeakBytes(); }

private:
  Use read(const GltfObject &json);
  void readMetal(const GltfObject &json, Material &material, Use &use);
  void readTransmission(const GltfObject &json, Material &material);
  void readEmission(const GltfObject &json, Material &material, Use &use);
  /// A texture as a material uses it, and which coordinates it takes.
  TextureUse readTexture(const GltfObject &info, std::uint64_t &uvSet);
  int readImage(const GltfObject &texture);
  void readWrap(const GltfObject &texture, TextureUse &use) const;
  Expected<int> decode(std::size_t index, const GltfObject &image);

  GltfContext &context_;
  GltfBuffers &buffers_;
  TextureSet textures_;
  GltfList list_;
  GltfList textureList_;
  GltfList imageList_;
  GltfList samplerList_;
  std::vector<std::optional<Use>> known_; ///< The last is that of primitives without one.
};

} // namespace voxc
