// Material, texture and vertex colours, multiplied.
#include "Mesh/SurfaceColour.h"

#include <algorithm>
#include <cmath>

namespace voxc {

namespace {

using Colour = std::array<double, 4>; ///< From 0 to 1.

Colour unpack(std::uint32_t word) {
  return {(word & 255) / 255.0, (word >> 8 & 255) / 255.0, (word >> 16 & 255) / 255.0, (word >> 24) / 255.0};
}

std::uint32_t pack(const Colour &colour) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < colour.size(); ++i)
    word |= static_cast<std::uint32_t>(std::lround(std::clamp(colour[i], 0.0, 1.0) * 255)) << 8 * i;
  return word;
}

/// The texel column or row of a coordinate that repeats every 1.
int texelIndex(double coordinate, int size) {
  const double fraction = coordinate - std::floor(coordinate);
  // Written so that a coordinate that is not a number takes the first texel.
  return fraction > 0 ? std::min(static_cast<int>(fraction * size), size - 1) : 0;
}

Colour sample(const Texture &texture, double u, double v) {
  const auto x = static_cast<std::size_t>(texelIndex(u, texture.width));
  const auto y = static_cast<std::size_t>(texelIndex(v, texture.height));
  return unpack(texture.texels[y * static_cast<std::size_t>(texture.width) + x]);
}

Colour vertexColour(const TriangleMesh &mesh, const Triangle &triangle, const Double3 &weights) {
  Colour mixed{};
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const Colour colour = unpack(mesh.colours[triangle.vertices[corner]]);
    for (std::size_t i = 0; i < mixed.size(); ++i)
      mixed[i] += weights[corner] * colour[i];
  }
  return mixed;
}

/// The texture's colour at a point; its alpha is that of the texture and the mask together.
Colour textureColour(const TriangleMesh &mesh, const Triangle &triangle, const Double3 &weights) {
  const Material &material = mesh.materials[triangle.material];
  double u = 0;
  double v = 0;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    u += weights[corner] * mesh.uvs[triangle.vertices[corner]][0];
    v += weights[corner] * mesh.uvs[triangle.vertices[corner]][1];
  }
  Colour colour{1, 1, 1, 1};
  if (material.texture >= 0)
    colour = sample(mesh.textures[static_cast<std::size_t>(material.texture)], u, v);
  if (material.opaque)
    colour[3] = 1;
  if (material.alphaMask >= 0)
    colour[3] *= sample(mesh.textures[static_cast<std::size_t>(material.alphaMask)], u, v)[0];
  return colour;
}

void multiply(Colour &colour, const Colour &other) {
  for (std::size_t i = 0; i < colour.size(); ++i)
    colour[i] *= other[i];
}

} // namespace

std::uint32_t surfaceColour(const TriangleMesh &mesh, const Triangle &triangle, const Double3 &weights) {
  const Material &material = mesh.materials[triangle.material];
  Colour colour{material.colour[0], material.colour[1], material.colour[2], material.colour[3]};
  if (!mesh.uvs.empty() && (material.texture >= 0 || material.alphaMask >= 0)) {
    Colour texture = textureColour(mesh, triangle, weights);
    if (texture[3] < 0.5)
      return 0;
    texture[3] = 1;
    multiply(colour, texture);
  }
  if (!mesh.colours.empty())
    multiply(colour, vertexColour(mesh, triangle, weights));
  colour[3] = std::max(colour[3], 1 / 255.0);
  return pack(colour);
}

} // namespace voxc
