// Base colours, emission and their textures.
#include "Mesh/Gltf/GltfMaterials.h"

#include "Mesh/Gltf/DataUri.h"

#include <algorithm>
#include <cmath>

namespace voxc {

namespace {

TextureWrap wrapOf(std::optional<std::uint64_t> code) {
  constexpr std::uint64_t kClampToEdge = 33071;
  constexpr std::uint64_t kMirroredRepeat = 33648;
  if (code == kClampToEdge)
    return TextureWrap::ClampToEdge;
  return code == kMirroredRepeat ? TextureWrap::MirroredRepeat : TextureWrap::Repeat;
}

/// Scale, then rotation, then offset. A positive angle turns from +v to +u: the extension's own example says
/// so, whose quarter of a turn ends in the lower left quadrant.
std::array<float, 6> textureMatrix(const GltfObject &transform) {
  const auto offset = transform.numbers<2>("offset", {0, 0});
  const auto scale = transform.numbers<2>("scale", {1, 1});
  const double angle = transform.number("rotation", 0);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const std::array<double, 6> matrix{c * scale[0],  s * scale[1], offset[0],
                                     -s * scale[0], c * scale[1], offset[1]};
  std::array<float, 6> result;
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = static_cast<float>(matrix[i]);
  return result;
}

void readAlpha(const GltfObject &json, Material &material) {
  const std::string_view mode = json.text("alphaMode");
  material.alpha = mode == "MASK" ? AlphaRule::Mask : mode == "BLEND" ? AlphaRule::Blend : AlphaRule::Opaque;
  if (material.alpha == AlphaRule::Mask)
    material.alphaCutoff = static_cast<float>(json.number("alphaCutoff", 0.5));
}

} // namespace

GltfMaterials::GltfMaterials(GltfContext &context, GltfBuffers &buffers)
    : context_(context), buffers_(buffers),
      textures_(context.memory, context.scene, context.warnings, ImageNumbers::Stored), // As glTF says.

      list_(context.root.list("materials")), textureList_(context.root.list("textures")),
      imageList_(context.root.list("images")), samplerList_(context.root.list("samplers")),
      known_(list_.size() + 1) {}

GltfMaterials::Use GltfMaterials::use(const GltfObject &primitive) {
  const std::size_t index = primitive.index("material", list_).value_or(list_.size());
  std::optional<Use> &known = known_[index];
  if (!known)
    known = read(list_[index]);
  return *known;
}

GltfMaterials::Use GltfMaterials::read(const GltfObject &json) {
  Use use;
  Material material;
  const GltfObject glossiness = json.extension("KHR_materials_pbrSpecularGlossiness");
  const GltfObject base = glossiness ? glossiness : json.object("pbrMetallicRoughness");
  const auto factor = base.numbers<4>(glossiness ? "diffuseFactor" : "baseColorFactor", {1, 1, 1, 1});
  for (std::size_t i = 0; i < factor.size(); ++i)
    material.colour[i] = static_cast<float>(factor[i]);
  material.isLinear = true;
  material.texture = readTexture(base.object(glossiness ? "diffuseTexture" : "baseColorTexture"), use.uvSet);
  readAlpha(json, material);
  if (const std::string mode(json.text("alphaMode"));
      material.alpha == AlphaRule::Opaque && !mode.empty() && mode != "OPAQUE")
    context_.warnings.add(json.name() + " has the alphaMode '" + mode.substr(0, 40) +
                          "', which is not known, and is taken for opaque");
  for (const char *texture : {"normalTexture", "occlusionTexture"})
    if (json.has(texture))
      context_.unused.insert(texture);
  // A material without light has a colour and nothing else.
  if (!json.extension("KHR_materials_unlit")) {
    readMetal(json.object("pbrMetallicRoughness"), material, use);
    readTransmission(json, material);
    readEmission(json, material, use);
  }
  context_.scene.materials.push_back(material);
  use.material = static_cast<std::uint32_t>(context_.scene.materials.size()) - 1;
  return use;
}

void GltfMaterials::readMetal(const GltfObject &json, Material &material, Use &use) {
  material.hasMetal =
      json.has("metallicFactor") || json.has("roughnessFactor") || json.has("metallicRoughnessTexture");
  material.metallic = static_cast<float>(json.number("metallicFactor", 1));
  material.roughness = static_cast<float>(json.number("roughnessFactor", 1));
  // Most models have such textures and most voxels no use for them.
  if (context_.wantsMetal)
    material.metalTexture = readTexture(json.object("metallicRoughnessTexture"), use.metalUvSet);
}

/// Its texture has it in red, that of metal and roughness in the other channels: they may be one.
void GltfMaterials::readTransmission(const GltfObject &json, Material &material) {
  const GltfObject transmission = json.extension("KHR_materials_transmission");
  const double factor = transmission.number("transmissionFactor", 0);
  if (!(factor > 0))
    return;
  const auto index = transmission.object("transmissionTexture").index("index", textureList_);
  const auto metal =
      json.object("pbrMetallicRoughness").object("metallicRoughnessTexture").index("index", textureList_);
  if (index != metal)
    return context_.warnings.add(
        json.name() +
        " lets light through by another texture than that of metal and roughness, which is left out");
  material.hasMetal = true;
  material.clear = static_cast<float>(factor);
}

void GltfMaterials::readEmission(const GltfObject &json, Material &material, Use &use) {
  // A colour cannot be brighter than white: strengths above 1 would only change its hue.
  const double strength = json.extension("KHR_materials_emissive_strength").number("emissiveStrength", 1);
  const auto factor = json.numbers<3>("emissiveFactor", {0, 0, 0});
  for (std::size_t i = 0; i < factor.size(); ++i)
    material.emission[i] = static_cast<float>(factor[i] * std::min(strength, 1.0));
  material.emissionStrength = static_cast<float>(std::max(strength, 1.0));
  if (material.emission == Material().emission && json.has("emissiveTexture"))
    context_.warnings.add(json.name() +
                          " has an emissiveTexture and an emissiveFactor of 0, so that it gives off nothing");
  if (material.emission != Material().emission)
    material.emissionTexture = readTexture(json.object("emissiveTexture"), use.emissionUvSet);
}

TextureUse GltfMaterials::readTexture(const GltfObject &info, std::uint64_t &uvSet) {
  TextureUse use;
  const auto index = info.index("index", textureList_);
  if (!index)
    return use;
  const GltfObject texture = textureList_[*index];
  use.texture = readImage(texture);
  readWrap(texture, use);
  uvSet = info.count("texCoord").value_or(0);
  if (const GltfObject transform = info.extension("KHR_texture_transform")) {
    use.matrix = textureMatrix(transform);
    uvSet = transform.count("texCoord").value_or(uvSet);
  }
  return use;
}

void GltfMaterials::readWrap(const GltfObject &texture, TextureUse &use) const {
  const auto index = texture.index("sampler", samplerList_);
  if (!index)
    return;
  const GltfObject sampler = samplerList_[*index];
  use.wrap = {wrapOf(sampler.count("wrapS")), wrapOf(sampler.count("wrapT"))};
}

int GltfMaterials::readImage(const GltfObject &texture) {
  const GltfObject webp = texture.extension("EXT_texture_webp");
  const auto index = webp ? webp.index("source", imageList_) : texture.index("source", imageList_);
  if (!index) {
    context_.warnings.add(texture.name() + " has no image of a kind that is read");
    return -1;
  }
  auto decoded = decode(*index, imageList_[*index]);
  if (decoded)
    return *decoded;
  context_.problem.set(decoded.error());
  return -1;
}

Expected<int> GltfMaterials::decode(std::size_t index, const GltfObject &image) {
  const std::string_view uri = image.text("uri");
  if (!uri.empty() && !isDataUri(uri))
    return textures_.readFile(context_.uris.path(uri));
  const auto view = image.index("bufferView", buffers_.views());
  // Images that share a buffer view are one.
  const std::string key = view ? "/view " + std::to_string(*view) : "/image " + std::to_string(index);
  return textures_.read(key, image.name(), [&](const TextureSet::Decode &decode) -> Expected<Texture> {
    if (!uri.empty()) {
      auto bytes = decodeDataUri(uri, context_.memory);
      return bytes ? decode(bytes->span()) : bytes.error();
    }
    return view ? decode(buffers_.view(*view).bytes) : Error::input("it has neither a uri nor a buffer view");
  });
}

} // namespace voxc
