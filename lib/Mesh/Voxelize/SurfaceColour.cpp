// Material, texture and vertex colours, multiplied, and emission.
#include "Mesh/Voxelize/SurfaceColour.h"

#include "Mesh/Voxelize/CornerRows.h"
#include "Mesh/Voxelize/TexelPlace.h"
#include "Support/Srgb.h"

#include <algorithm>

namespace voxc {

namespace {

using Colour = std::array<double, 4>; ///< From 0 to 1.

/// n / 255 for each n.
constexpr std::array<double, 256> kFractions = [] {
  std::array<double, 256> fractions{};
  for (std::size_t n = 0; n < fractions.size(); ++n)
    fractions[n] = static_cast<double>(n) / 255;
  return fractions;
}();

/// The byte of a value as it is; 0 of what is not a number.
std::uint32_t plainByte(double value) {
  const double share = value > 0 ? std::min(value, 1.0) : 0;
  const double raised = share * 255 + 0.5; // std::lround is a call.
  return static_cast<std::uint32_t>(raised);
}

/// How the numbers of a material stand for bytes in sRGB.
struct ColourSpace {
  const std::array<double, 256> &numbers; ///< Of bytes.
  std::uint32_t (*byte)(double number);
};

/// Numbers that are taken as they are, and linear light.
const std::array<ColourSpace, 2> kSpaces{{{kFractions, plainByte}, {kLinearLight, srgbByte}}};

Colour unpack(const ColourSpace &space, std::uint32_t word) {
  return {space.numbers[word & 255], space.numbers[word >> 8 & 255], space.numbers[word >> 16 & 255],
          kFractions[word >> 24]};
}

void multiply(Colour &colour, const Colour &other) {
  for (std::size_t i = 0; i < colour.size(); ++i)
    colour[i] *= other[i];
}

bool hasTexture(const MeshPart &part, const Material &material) {
  return (part.uvs && (material.texture.texture >= 0 || material.alphaMask.texture >= 0)) ||
         (part.emissionUvs && material.emissionTexture.texture >= 0);
}

/// Is the colour of a surface that of its texel alone?
bool isPlain(const MeshPart &part, const Material &material) {
  const Material plain;
  return !part.colours && material.colour == plain.colour && material.emission == plain.emission;
}

/// The byte of alpha of a surface that the texture leaves `textureAlpha`, of 0 to 1, and the factor and the
/// vertices `ownAlpha`; nothing where it is cut out.
std::optional<std::uint32_t> alphaByte(const Material &material, double textureAlpha, double ownAlpha) {
  if (material.alpha == AlphaRule::Opaque)
    return 255;
  const bool isMask = material.alpha == AlphaRule::Mask;
  // Files have cutoffs in decimals, 0.2 of which is not below 51 of 255: float32 makes them equal.
  if (static_cast<float>(isMask ? textureAlpha * ownAlpha : textureAlpha) < material.alphaCutoff)
    return std::nullopt;
  if (isMask)
    return 255;
  const std::uint32_t byte = plainByte(ownAlpha);
  if (byte == 0 && material.alpha == AlphaRule::Blend)
    return std::nullopt;
  return std::max(byte, std::uint32_t{1});
}

/// A word with an alpha, or 0 where there is none.
std::uint32_t withAlpha(std::uint32_t word, std::optional<std::uint32_t> alpha) {
  return alpha ? (word & 0xffffff) | *alpha << 24 : 0;
}

/// The word of a colour whose alpha is the factor's and the vertices', or 0 where it is cut out.
std::uint32_t wordOf(const Material &material, const Colour &colour, double textureAlpha) {
  const ColourSpace &space = kSpaces[material.isLinear];
  const std::uint32_t word = space.byte(colour[0]) | space.byte(colour[1]) << 8 | space.byte(colour[2]) << 16;
  return withAlpha(word, alphaByte(material, textureAlpha, colour[3]));
}

/// Factor, texel and vertex colour multiplied, and emission added, whose texel is `emission`. Alpha is that
/// of the factor and the vertices.
Colour surfaceOf(const Material &material, std::uint32_t texel, const Colour &vertices,
                 std::uint32_t emission) {
  const ColourSpace &space = kSpaces[material.isLinear];
  const auto &factor = material.colour;
  Colour colour{factor[0], factor[1], factor[2], factor[3]};
  multiply(colour, vertices);
  multiply(colour, unpack(space, texel | 0xff000000));
  const Colour glow = unpack(space, emission);
  for (std::size_t i = 0; i < material.emission.size(); ++i)
    colour[i] += material.emission[i] * glow[i];
  return colour;
}

constexpr Colour kWhite{1, 1, 1, 1};
constexpr std::uint32_t kWhiteWord = ~std::uint32_t{0};

} // namespace

SurfaceColour::SurfaceColour(const TriangleScene &scene, const SceneMeans &means)
    : scene_(scene), means_(means) {
  for (const MeshPart &part : scene.parts) {
    const Material &material = scene.materials[part.material];
    std::optional<std::uint32_t> &constant = constants_.emplace_back();
    if (!part.colours && !hasTexture(part, material))
      constant = wordOf(material, surfaceOf(material, kWhiteWord, kWhite, kWhiteWord), 1);
  }
}

void SurfaceColour::moveTo(const TriangleCursor &cursor) {
  constant_ = constants_[cursor.partIndex()];
  part_ = &cursor.part();
  material_ = &scene_.materials[part_->material];
  isPlain_ = isPlain(*part_, *material_);
  vertices_ = cursor.vertices();
}

void SurfaceColour::load() {
  for (std::size_t corner = 0; corner < 3; ++corner) {
    if (part_->uvs)
      uvs_[corner] = readRow<2>(part_->uvs, vertices_[corner]);
    if (part_->emissionUvs)
      emissionUvs_[corner] = readRow<2>(part_->emissionUvs, vertices_[corner]);
    if (part_->colours)
      colours_[corner] = readRow<4>(part_->colours, vertices_[corner]);
    if (part_->colours.components < 4)
      colours_[corner][3] = 1;
  }
}

/// Texels lie anywhere in memory, so all places are found before the first is looked at: then the processor
/// waits for many at once.
void SurfaceColour::sample(const TextureUse &use, const CornerUvs &uvs, std::span<const glm::dvec3> weights,
                           Texels &texels) {
  if (use.texture < 0)
    return texels.assign(weights.size(), kWhiteWord);
  const Texture &texture = scene_.textures[static_cast<std::size_t>(use.texture)];
  const UvEnds ends(use, uvs);
  places_.clear();
  for (const glm::dvec3 &point : weights)
    places_.push_back(texelAt(texture, use, ends.within(mappedUv(use, mixed(uvs, point)))));
  const std::uint32_t *first = texture.texels->data();
  texels.clear();
  for (const std::uint64_t place : places_)
    texels.push_back(first[place]);
}

std::optional<Footprint> SurfaceColour::footprintOf(const TextureUse &use, bool isOpaque,
                                                    const CornerUvs &uvs,
                                                    const NearestPoints &triangle) const {
  const TextureMeans *means = means_.find(use.texture, isOpaque);
  if (!means)
    return std::nullopt;
  const Footprint footprint(*means, use, uvs, triangle.gradients());
  return footprint.isFiner() ? std::optional(footprint) : std::nullopt;
}

void SurfaceColour::average(const Footprint &footprint, const TextureUse &use, bool isOpaque,
                            std::span<const glm::dvec3> weights, Texels &texels) {
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (isOpaque || texels[i] >> 24 != 0)
      if (const auto mean = boxMeans_.of(footprint.means(), use.wrap, footprint.at(weights[i])))
        texels[i] = *mean | (texels[i] & 0xff000000);
}

std::uint32_t SurfaceColour::shaded(std::size_t point, const glm::dvec3 &weights) const {
  const double textureAlpha =
      kFractions[texels_[point] >> 24] * kFractions[masks_[point] >> 8 * material_->alphaChannel & 255];
  if (isPlain_)
    return withAlpha(texels_[point], alphaByte(*material_, textureAlpha, 1));
  const Colour vertices = part_->colours ? mixed(colours_, weights) : kWhite;
  return wordOf(*material_, surfaceOf(*material_, texels_[point], vertices, emissions_[point]), textureAlpha);
}

bool SurfaceColour::measure(const NearestPoints &triangle) {
  if (constant_)
    return false;
  load();
  footprint_.reset();
  emissionFootprint_.reset();
  if (part_->uvs)
    footprint_ = footprintOf(material_->texture, material_->alpha == AlphaRule::Opaque, uvs_, triangle);
  if (part_->emissionUvs)
    emissionFootprint_ = footprintOf(material_->emissionTexture, true, emissionUvs_, triangle);
  return footprint_ || emissionFootprint_;
}

void SurfaceColour::at(std::span<const glm::dvec3> weights, std::vector<std::uint32_t> &words) {
  if (constant_)
    return words.assign(weights.size(), *constant_);
  const TextureUse none;
  const TextureUse &texture = part_->uvs ? material_->texture : none;
  const TextureUse &emission = part_->emissionUvs ? material_->emissionTexture : none;
  sample(texture, uvs_, weights, texels_);
  sample(part_->uvs ? material_->alphaMask : none, uvs_, weights, masks_);
  sample(emission, emissionUvs_, weights, emissions_);
  if (footprint_)
    average(*footprint_, texture, material_->alpha == AlphaRule::Opaque, weights, texels_);
  if (emissionFootprint_)
    average(*emissionFootprint_, emission, true, weights, emissions_);
  words.clear();
  for (std::size_t i = 0; i < weights.size(); ++i)
    words.push_back(shaded(i, weights[i]));
}

} // namespace voxc
