// Base colours and their textures.
#include "Mesh/Gltf/GltfMaterials.h"

#include "Mesh/Gltf/DataUri.h"

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

/// Alpha below the cutoff is cut out, that of the factor included, which the texture's alpha is multiplied
/// by.
void readAlpha(const GltfObject &json, Material &material) {
  const std::string_view mode = json.text("alphaMode");
  material.opaque = mode.empty() || mode == "OPAQUE";
  if (mode != "MASK")
    return;
  constexpr float kEverything = 2;
  const auto cutoff = static_cast<float>(json.number("alphaCutoff", 0.5));
  material.alphaCutoff = material.colour[3] > 0 ? cutoff / material.colour[3] : kEverything;
}

} // namespace

GltfMaterials::GltfMaterials(GltfContext &context, GltfBuffers &buffers)
    : context_(context), buffers_(buffers), textures_(context.memory, context.scene, context.warnings),
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
  readTexture(base.object(glossiness ? "diffuseTexture" : "baseColorTexture"), material, use);
  readAlpha(json, material);
  context_.scene.materials.push_back(material);
  use.material = static_cast<std::uint32_t>(context_.scene.materials.size()) - 1;
  return use;
}

void GltfMaterials::readTexture(const GltfObject &info, Material &material, Use &use) {
  const auto index = info.index("index", textureList_);
  if (!index)
    return;
  const GltfObject texture = textureList_[*index];
  material.texture.texture = readImage(texture);
  readWrap(texture, material.texture);
  use.uvSet = info.count("texCoord").value_or(0);
  if (const GltfObject transform = info.extension("KHR_texture_transform")) {
    material.texture.matrix = textureMatrix(transform);
    use.uvSet = transform.count("texCoord").value_or(use.uvSet);
  }
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
    return textures_.readFile(context_.folder + uriToPath(uri));
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
