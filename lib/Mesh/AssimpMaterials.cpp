// From assimp's materials to voxc's: a colour, a texture, a mask.
#include "Mesh/AssimpMaterials.h"

#include "Mesh/ImageDecoder.h"
#include "voxc/Support/File.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <map>
#include <utility>

namespace voxc {

namespace {

/// Decodes each image once, from the scene or from the model's folder.
class TextureReader {
public:
  TextureReader(const aiScene &scene, std::string folder, TriangleMesh &mesh)
      : scene_(scene), folder_(std::move(folder)), mesh_(mesh) {}

  /// Index of the texture, or -1 with a warning.
  int read(const std::string &name) {
    const auto [entry, isNew] = indices_.try_emplace(name, -1);
    if (!isNew)
      return entry->second;
    Expected<Texture> texture = decode(name);
    if (!texture) {
      mesh_.warnings.push_back("the texture '" + name + "' is left out: " + texture.error().message);
      return -1;
    }
    mesh_.textures.push_back(std::move(*texture));
    return entry->second = static_cast<int>(mesh_.textures.size()) - 1;
  }

private:
  Expected<Texture> decode(const std::string &name) const {
    if (const aiTexture *embedded = scene_.GetEmbeddedTexture(name.c_str()))
      return decodeEmbedded(*embedded);
    std::string path = name;
    std::replace(path.begin(), path.end(), '\\', '/');
    auto file = MappedFile::open(path.starts_with('/') ? path : folder_ + path);
    if (!file)
      return file.error();
    return decodeImage(file->bytes());
  }

  static Expected<Texture> decodeEmbedded(const aiTexture &embedded) {
    const auto *bytes = reinterpret_cast<const std::byte *>(embedded.pcData);
    if (embedded.mHeight == 0) // A compressed image of mWidth bytes.
      return decodeImage({bytes, embedded.mWidth});
    Texture texture{static_cast<int>(embedded.mWidth), static_cast<int>(embedded.mHeight), {}};
    const std::size_t count = std::size_t{embedded.mWidth} * embedded.mHeight;
    for (std::size_t i = 0; i < count; ++i) {
      const aiTexel &texel = embedded.pcData[i];
      texture.texels.push_back(texel.r | texel.g << 8u | texel.b << 16u | std::uint32_t{texel.a} << 24u);
    }
    return texture;
  }

  const aiScene &scene_;
  std::string folder_;
  TriangleMesh &mesh_;
  std::map<std::string, int> indices_;
};

/// Name of a material's texture, or empty.
std::string textureName(const aiMaterial &material, aiTextureType type) {
  aiString name;
  return material.GetTexture(type, 0, &name) == aiReturn_SUCCESS ? name.C_Str() : "";
}

std::array<float, 4> colourOf(const aiMaterial &material) {
  // assimp's stand-in for "no material" is grey; no colour is white.
  if (material.GetName() == aiString(AI_DEFAULT_MATERIAL_NAME))
    return {1, 1, 1, 1};
  aiColor4D colour(1, 1, 1, 1);
  if (material.Get(AI_MATKEY_BASE_COLOR, colour) == aiReturn_SUCCESS)
    return {colour.r, colour.g, colour.b, colour.a};
  material.Get(AI_MATKEY_COLOR_DIFFUSE, colour);
  float opacity = 1;
  material.Get(AI_MATKEY_OPACITY, opacity);
  return {colour.r, colour.g, colour.b, opacity};
}

bool isOpaque(const aiMaterial &material) {
  aiString mode;
  return material.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) == aiReturn_SUCCESS && mode == aiString("OPAQUE");
}

Material readMaterial(const aiMaterial &material, TextureReader &textures) {
  Material result;
  result.colour = colourOf(material);
  result.opaque = isOpaque(material);
  std::string colour = textureName(material, aiTextureType_DIFFUSE);
  if (colour.empty())
    colour = textureName(material, aiTextureType_BASE_COLOR);
  const std::string mask = textureName(material, aiTextureType_OPACITY);
  if (!colour.empty())
    result.texture = textures.read(colour);
  // A mask that is the texture itself means that texture's alpha, which counts anyway.
  if (!mask.empty() && mask != colour)
    result.alphaMask = textures.read(mask);
  return result;
}

} // namespace

std::vector<unsigned> readMaterials(const aiScene &scene, const std::string &folder, TriangleMesh &mesh) {
  TextureReader textures(scene, folder, mesh);
  std::vector<unsigned> uvSets;
  for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
    const aiMaterial &material = *scene.mMaterials[i];
    mesh.materials.push_back(readMaterial(material, textures));
    int uvSet = 0;
    material.Get(AI_MATKEY_UVWSRC(aiTextureType_DIFFUSE, 0), uvSet);
    uvSets.push_back(static_cast<unsigned>(std::max(uvSet, 0)));
  }
  return uvSets;
}

} // namespace voxc
