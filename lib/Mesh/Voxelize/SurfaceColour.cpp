// Material, texture and vertex colours, multiplied.
#include "Mesh/Voxelize/SurfaceColour.h"

#include <algorithm>
#include <cmath>

namespace voxc {

namespace {

using Colour = std::array<double, 4>; ///< From 0 to 1.
using Uv = std::array<double, 2>;

/// n / 255 for each n.
constexpr std::array<double, 256> kFractions = [] {
  std::array<double, 256> fractions{};
  for (std::size_t n = 0; n < fractions.size(); ++n)
    fractions[n] = static_cast<double>(n) / 255;
  return fractions;
}();

Colour unpack(std::uint32_t word) {
  return {kFractions[word & 255], kFractions[word >> 8 & 255], kFractions[word >> 16 & 255],
          kFractions[word >> 24]};
}

/// Written so that a colour that is not a number is 0.
std::uint32_t pack(const Colour &colour) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < colour.size(); ++i) {
    const double share = colour[i] > 0 ? std::min(colour[i], 1.0) : 0;
    const double rounded = share * 255 + 0.5; // Cut below; std::lround is a call.
    word |= static_cast<std::uint32_t>(rounded) << 8 * i;
  }
  return word;
}

/// What is left above the integer below. Numbers so large that they are integers, and what is no number,
/// leave nothing. (`std::floor` is a call on processors that may lack the instruction.)
double fractionOf(double value) {
  if (!(std::abs(value) < 0x1p52))
    return 0;
  const double cut = value - static_cast<double>(static_cast<std::int64_t>(value));
  return cut < 0 ? cut + 1 : cut;
}

double repeated(double coordinate) { return fractionOf(coordinate); }

double mirrored(double coordinate) {
  const double fraction = 2 * fractionOf(coordinate / 2);
  return fraction > 1 ? 2 - fraction : fraction;
}

double clamped(double coordinate) { return coordinate; }

/// Where a coordinate falls in the texture, which reaches from 0 to 1; in the order of `TextureWrap`.
constexpr std::array<double (*)(double), 3> kWraps{repeated, mirrored, clamped};

/// The texel column or row of a coordinate; the first of one that is not a number.
int texelIndex(double coordinate, TextureWrap wrap, int size) {
  // Most textures repeat: no call for them.
  const double place =
      wrap == TextureWrap::Repeat ? repeated(coordinate) : kWraps[static_cast<std::size_t>(wrap)](coordinate);
  return place > 0 ? static_cast<int>(std::min<double>(place * size, size - 1)) : 0;
}

/// Where the texel at a point is.
std::uint64_t texelAt(const Texture &texture, const TextureUse &use, const Uv &uv) {
  const std::array<float, 6> &m = use.matrix;
  const double u = m[0] * uv[0] + m[1] * uv[1] + m[2];
  const double v = m[3] * uv[0] + m[4] * uv[1] + m[5];
  const auto x = static_cast<std::uint64_t>(texelIndex(u, use.wrap[0], texture.width));
  const auto y = static_cast<std::uint64_t>(texelIndex(v, use.wrap[1], texture.height));
  return y * static_cast<std::uint64_t>(texture.width) + x;
}

bool usesTexture(const MeshPart &part, const Material &material) {
  return part.uvs && (material.texture.texture >= 0 || material.alphaMask.texture >= 0);
}

Colour factorOf(const Material &material) {
  return {material.colour[0], material.colour[1], material.colour[2], material.colour[3]};
}

void multiply(Colour &colour, const Colour &other) {
  for (std::size_t i = 0; i < colour.size(); ++i)
    colour[i] *= other[i];
}

std::uint32_t visible(Colour colour) {
  constexpr double kLeast = 1 / 255.0;
  colour[3] = colour[3] > kLeast ? colour[3] : kLeast;
  return pack(colour);
}

/// The sum of three corners' rows by their weights.
template <std::size_t N>
std::array<double, N> mixed(const std::array<std::array<double, N>, 3> &rows, const glm::dvec3 &weights) {
  std::array<double, N> sum{};
  for (std::size_t corner = 0; corner < 3; ++corner)
    for (std::size_t i = 0; i < N; ++i)
      sum[i] += weights[corner] * rows[corner][i];
  return sum;
}

} // namespace

SurfaceColour::SurfaceColour(const TriangleScene &scene) : scene_(scene) {
  for (const MeshPart &part : scene.parts) {
    const Material &material = scene.materials[part.material];
    const bool isOne = !part.colours && !usesTexture(part, material);
    constants_.push_back(isOne ? visible(factorOf(material)) : 0);
  }
}

void SurfaceColour::moveTo(const TriangleCursor &cursor) {
  constant_ = constants_[cursor.partIndex()];
  part_ = &cursor.part();
  vertices_ = cursor.vertices();
  isLoaded_ = false;
}

void SurfaceColour::load() {
  isLoaded_ = true;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    if (part_->uvs)
      uvs_[corner] = readRow<2>(part_->uvs, vertices_[corner]);
    if (part_->colours)
      colours_[corner] = readRow<4>(part_->colours, vertices_[corner]);
    if (part_->colours.components < 4)
      colours_[corner][3] = 1;
  }
}

/// Texels lie anywhere in memory, so all places are found before the first is looked at: then the processor
/// waits for many at once.
void SurfaceColour::sample(const TextureUse &use, std::span<const glm::dvec3> weights,
                           std::vector<std::uint32_t> &texels) {
  const Texture &texture = scene_.textures[static_cast<std::size_t>(use.texture)];
  places_.clear();
  for (const glm::dvec3 &point : weights)
    places_.push_back(texelAt(texture, use, mixed(uvs_, point)));
  const std::uint32_t *first = texture.texels->data();
  texels.clear();
  for (const std::uint64_t place : places_)
    texels.push_back(first[place]);
}

/// Sets `words` to the opaque texels, or to 0 where the triangle is cut away.
void SurfaceColour::sampleAll(std::span<const glm::dvec3> weights, std::vector<std::uint32_t> &words) {
  const Material &material = scene_.materials[part_->material];
  words.assign(weights.size(), ~std::uint32_t{0});
  masks_.assign(weights.size(), ~std::uint32_t{0});
  if (!usesTexture(*part_, material))
    return;
  if (material.texture.texture >= 0)
    sample(material.texture, weights, words);
  if (material.alphaMask.texture >= 0)
    sample(material.alphaMask, weights, masks_);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const double alpha = kFractions[words[i] >> 24] * kFractions[masks_[i] & 255];
    const bool isCut = !material.opaque && alpha < material.alphaCutoff;
    words[i] = isCut ? 0 : words[i] | 0xff000000;
  }
}

std::uint32_t SurfaceColour::shaded(std::uint32_t texel, const glm::dvec3 &weights) const {
  Colour colour = factorOf(scene_.materials[part_->material]);
  multiply(colour, unpack(texel));
  if (part_->colours)
    multiply(colour, mixed(colours_, weights));
  return visible(colour);
}

void SurfaceColour::at(std::span<const glm::dvec3> weights, std::vector<std::uint32_t> &words) {
  if (constant_ != 0)
    return words.assign(weights.size(), constant_);
  if (!isLoaded_)
    load();
  sampleAll(weights, words);
  const bool isWhite = scene_.materials[part_->material].colour == std::array<float, 4>{1, 1, 1, 1};
  if (isWhite && !part_->colours)
    return;
  for (std::size_t i = 0; i < words.size(); ++i)
    if (words[i] != 0)
      words[i] = shaded(words[i], weights[i]);
}

} // namespace voxc
