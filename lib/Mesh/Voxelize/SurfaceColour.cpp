// Material, texture and vertex colours, multiplied.
#include "Mesh/Voxelize/SurfaceColour.h"

#include <algorithm>
#include <cmath>

namespace voxc {

namespace {

using Colour = std::array<double, 4>; ///< From 0 to 1.
using Uv = std::array<double, 2>;

Colour unpack(std::uint32_t word) {
  return {(word & 255) / 255.0, (word >> 8 & 255) / 255.0, (word >> 16 & 255) / 255.0, (word >> 24) / 255.0};
}

/// Written so that a colour that is not a number is 0.
std::uint32_t pack(const Colour &colour) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < colour.size(); ++i) {
    const double part = colour[i] > 0 ? std::min(colour[i], 1.0) : 0;
    word |= static_cast<std::uint32_t>(part * 255 + 0.5) << 8 * i;
  }
  return word;
}

/// Where a coordinate falls in [0, 1]; one that is not a number anywhere.
double wrapped(double coordinate, TextureWrap wrap) {
  switch (wrap) {
  case TextureWrap::ClampToEdge:
    return coordinate;
  case TextureWrap::MirroredRepeat: {
    const double fraction = coordinate - 2 * std::floor(coordinate / 2);
    return fraction > 1 ? 2 - fraction : fraction;
  }
  case TextureWrap::Repeat:
    break;
  }
  return coordinate - std::floor(coordinate);
}

/// The texel column or row of a coordinate; the first of one that is not a number.
int texelIndex(double coordinate, TextureWrap wrap, int size) {
  const double place = wrapped(coordinate, wrap) * size;
  return place > 0 ? static_cast<int>(std::min<double>(place, size - 1)) : 0;
}

std::uint32_t sample(const TriangleScene &scene, const TextureUse &use, const Uv &uv) {
  const Texture &texture = scene.textures[static_cast<std::size_t>(use.texture)];
  const std::array<float, 6> &m = use.matrix;
  const double u = m[0] * uv[0] + m[1] * uv[1] + m[2];
  const double v = m[3] * uv[0] + m[4] * uv[1] + m[5];
  const auto x = static_cast<std::uint64_t>(texelIndex(u, use.wrap[0], texture.width));
  const auto y = static_cast<std::uint64_t>(texelIndex(v, use.wrap[1], texture.height));
  return (*texture.texels)[y * static_cast<std::uint64_t>(texture.width) + x];
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
std::array<double, N> mixed(const std::array<std::array<double, N>, 3> &rows, const Double3 &weights) {
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

std::uint32_t SurfaceColour::varied(const Double3 &weights) {
  if (!isLoaded_)
    load();
  const Material &material = scene_.materials[part_->material];
  Colour colour = factorOf(material);
  if (usesTexture(*part_, material)) {
    const Uv uv = mixed(uvs_, weights);
    const bool hasTexture = material.texture.texture >= 0;
    Colour texture = hasTexture ? unpack(sample(scene_, material.texture, uv)) : Colour{1, 1, 1, 1};
    if (material.alphaMask.texture >= 0)
      texture[3] *= (sample(scene_, material.alphaMask, uv) & 255) / 255.0;
    if (!material.opaque && texture[3] < material.alphaCutoff)
      return 0;
    texture[3] = 1;
    multiply(colour, texture);
  }
  if (part_->colours)
    multiply(colour, mixed(colours_, weights));
  return visible(colour);
}

} // namespace voxc
