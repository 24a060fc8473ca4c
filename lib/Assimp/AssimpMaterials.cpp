// Colours and textures by assimp's keys.
#include "Assimp/AssimpMaterials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace voxc {

namespace {

/// Textures that are a surface's colour, the likeliest first.
constexpr std::array<aiTextureType, 2> kColourTypes{aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE};
/// Those of what it gives off.
constexpr std::array<aiTextureType, 2> kEmissionTypes{aiTextureType_EMISSION_COLOR, aiTextureType_EMISSIVE};
constexpr float kMostEmission = 1e9f;

struct TypeName {
  aiTextureType type;
  const char *name;
};

constexpr std::array kOtherTypes =
    std::to_array<TypeName>({{aiTextureType_SPECULAR, "specular"},
                             {aiTextureType_AMBIENT, "ambient"},
                             {aiTextureType_HEIGHT, "height"},
                             {aiTextureType_NORMALS, "normals"},
                             {aiTextureType_NORMAL_CAMERA, "normals"},
                             {aiTextureType_SHININESS, "shininess"},
                             {aiTextureType_OPACITY, "opacity"},
                             {aiTextureType_DISPLACEMENT, "displacement"},
                             {aiTextureType_LIGHTMAP, "light"},
                             {aiTextureType_AMBIENT_OCCLUSION, "occlusion"},
                             {aiTextureType_REFLECTION, "reflection"},
                             {aiTextureType_METALNESS, "metalness"},
                             {aiTextureType_DIFFUSE_ROUGHNESS, "roughness"},
                             {aiTextureType_SHEEN, "sheen"},
                             {aiTextureType_CLEARCOAT, "clearcoat"},
                             {aiTextureType_TRANSMISSION, "transmission"},
                             {aiTextureType_UNKNOWN, "of no kind that is known"}});

TextureWrap wrapOf(int mode) {
  if (mode == aiTextureMapMode_Mirror)
    return TextureWrap::MirroredRepeat;
  return mode == aiTextureMapMode_Wrap ? TextureWrap::Repeat : TextureWrap::ClampToEdge;
}

/// A share of a material, if it has one.
std::optional<float> shareOf(const aiMaterial &from, const char *key, unsigned type, unsigned index) {
  float share = 0;
  if (from.Get(key, type, index, share) != aiReturn_SUCCESS || std::isnan(share))
    return std::nullopt;
  return std::clamp(share, 0.0f, 1.0f);
}

bool isBlack(const aiColor4D &colour) { return colour.r == 0 && colour.g == 0 && colour.b == 0; }

} // namespace

AssimpMaterials::AssimpMaterials(const aiScene &from, const MeshInput &input, TriangleScene &scene,
                                 Warnings &warnings, Problem &problem)
    : from_(from), input_(input), scene_(scene), warnings_(warnings), problem_(problem),
      textures_(input.memory, scene, warnings) {}

void AssimpMaterials::readAll() {
  for (unsigned i = 0; i < from_.mNumMaterials; ++i) {
    AssimpUvSets uvSets;
    scene_.materials.push_back(read(*from_.mMaterials[i], uvSets));
    uvSets_.push_back(uvSets);
  }
  if (scene_.materials.empty())
    scene_.materials.emplace_back();
  std::string names;
  for (const std::string &name : unused_)
    names += (names.empty() ? "" : ", ") + name;
  if (!names.empty())
    warnings_.add("these kinds of textures are not used: " + names);
}

Material AssimpMaterials::read(const aiMaterial &from, AssimpUvSets &uvSets) {
  Material material;
  material.texture = readTexture(from, kColourTypes, uvSets.colour);
  noteOthers(from);
  aiColor4D colour(1, 1, 1, 1);
  const bool hasColour = from.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == aiReturn_SUCCESS ||
                         from.Get(AI_MATKEY_BASE_COLOR, colour) == aiReturn_SUCCESS;
  const bool isTextured = material.texture.texture >= 0;
  // Some programs write black beside a texture, and show the texture.
  if (hasColour && !(isTextured && isBlack(colour)))
    material.colour = {colour.r, colour.g, colour.b, 1};
  else if (hasColour)
    warnOnce("a material is black beside a texture, which is taken as it is");
  float opacity = 1;
  if (from.Get(AI_MATKEY_OPACITY, opacity) == aiReturn_SUCCESS && opacity > 0)
    material.colour[3] = opacity;
  else if (opacity <= 0)
    warnOnce("a material would be wholly invisible, and is taken for opaque");
  readEmission(from, material, uvSets.emission);
  const auto metallic = shareOf(from, AI_MATKEY_METALLIC_FACTOR);
  const auto roughness = shareOf(from, AI_MATKEY_ROUGHNESS_FACTOR);
  material.hasMetal = metallic || roughness;
  material.metallic = metallic.value_or(0);
  material.roughness = roughness.value_or(1);
  return material;
}

/// Light above 1 keeps its hue; a texture beside black is what the surface gives off, as most formats have
/// either.
void AssimpMaterials::readEmission(const aiMaterial &from, Material &material, unsigned &uvSet) {
  material.emissionTexture = readTexture(from, kEmissionTypes, uvSet);
  aiColor4D colour(0, 0, 0, 1);
  float intensity = 1;
  from.Get(AI_MATKEY_COLOR_EMISSIVE, colour);
  if (from.Get(AI_MATKEY_EMISSIVE_INTENSITY, intensity) != aiReturn_SUCCESS)
    intensity = 1;
  material.emission = {colour.r, colour.g, colour.b};
  for (float &channel : material.emission)
    channel = channel * intensity > 0 ? std::min(channel * intensity, kMostEmission) : 0;
  if (material.emission == Material().emission && material.emissionTexture.texture >= 0)
    material.emission.fill(1);
  material.emissionStrength = std::max(std::ranges::max(material.emission), 1.0f);
  for (float &channel : material.emission)
    channel /= material.emissionStrength;
}

void AssimpMaterials::noteOthers(const aiMaterial &from) {
  for (const TypeName &other : kOtherTypes)
    if (from.GetTextureCount(other.type) != 0)
      unused_.insert(other.name);
}

TextureUse AssimpMaterials::readTexture(const aiMaterial &from, std::span<const aiTextureType> types,
                                        unsigned &uvSet) {
  TextureUse use;
  for (const aiTextureType type : types) {
    aiString name;
    if (from.GetTexture(type, 0, &name) != aiReturn_SUCCESS)
      continue;
    if (from.GetTextureCount(type) > 1)
      warnOnce("a material has several textures of its colour or of what it gives off; the first is used");
    use.texture = imageOf(name.C_Str());
    int value = aiTextureMapping_UV;
    if (from.Get(AI_MATKEY_MAPPING(type, 0), value) == aiReturn_SUCCESS && value != aiTextureMapping_UV)
      warnOnce("a texture is laid on by a shape, which is not done: texture coordinates count");
    value = 0;
    if (from.Get(AI_MATKEY_UVWSRC(type, 0), value) == aiReturn_SUCCESS && value > 0)
      uvSet = static_cast<unsigned>(value);
    if (from.Get(AI_MATKEY_MAPPINGMODE_U(type, 0), value) == aiReturn_SUCCESS)
      use.wrap[0] = wrapOf(value);
    if (from.Get(AI_MATKEY_MAPPINGMODE_V(type, 0), value) == aiReturn_SUCCESS)
      use.wrap[1] = wrapOf(value);
    aiUVTransform moved;
    if (from.Get(AI_MATKEY_UVTRANSFORM(type, 0), moved) == aiReturn_SUCCESS) {
      if (moved.mRotation != 0)
        warnOnce("the turn of a texture is not used");
      use.matrix = {moved.mScaling.x, 0, moved.mTranslation.x, 0, moved.mScaling.y, moved.mTranslation.y};
    }
    // assimp counts v from below, the scene from above.
    use.matrix[4] = -use.matrix[4];
    use.matrix[5] = 1 - use.matrix[5];
    return use;
  }
  return use;
}

void AssimpMaterials::warnOnce(const std::string &sentence) {
  if (said_.insert(sentence).second)
    warnings_.add(sentence);
}

/// An .x3d may have several names, each in quotes, of which one is enough.
int AssimpMaterials::imageOf(const std::string &names) {
  const std::size_t begin = names.starts_with('"') ? 1 : 0;
  const std::string name = names.substr(begin, names.find('"', begin) - begin);
  const aiTexture *const within = from_.GetEmbeddedTexture(name.c_str());
  return within ? embedded(name, *within) : fileOf(name);
}

/// A whole image file, or texels.
int AssimpMaterials::embedded(const std::string &name, const aiTexture &texture) {
  if (texture.mHeight != 0) {
    warnOnce("the texture '" + name + "' is left out: its texels are in the file without a format");
    return -1;
  }
  return checked(textures_.read("embedded " + name, name, [&](const TextureSet::Decode &decode) {
    return decode({reinterpret_cast<const std::byte *>(texture.pcData), texture.mWidth});
  }));
}

int AssimpMaterials::fileOf(const std::string &name) {
  const std::string folder = input_.folder();
  const auto found = files_.find(name, std::span(&folder, 1));
  if (found && found->isElsewhere)
    warnOnce("the texture '" + name + "' is not there; '" + found->path + "' beside the model is taken");
  return checked(textures_.readFile(found ? found->path : pathBelow(folder, name)));
}

int AssimpMaterials::checked(const Expected<int> &index) {
  if (!index)
    problem_.set(index.error());
  return index ? *index : -1;
}

} // namespace voxc
