// The colour of a scene at points of its triangles.
#pragma once

#include "Mesh/ModelFrame.h"
#include "Mesh/Voxelize/TriangleCursor.h"
#include "voxc/Mesh/TriangleScene.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace voxc {

/// The colour of one triangle after the other: texture, material and vertex colour multiplied, taken as they
/// are, without a change of colour space.
class SurfaceColour {
public:
  /// The scene, which is checked, must outlive this.
  explicit SurfaceColour(const TriangleScene &scene);

  /// Goes to the triangle at which `cursor` stands.
  void moveTo(const TriangleCursor &cursor);

  /// Sets `words` to those at the points with these weights, or to 0 where texture and mask cut the triangle
  /// away. What remains has the alpha of the material and the vertices, but at least 1, so that the word is
  /// not "empty".
  void at(std::span<const glm::dvec3> weights, std::vector<std::uint32_t> &words);

private:
  void load();
  void sample(const TextureUse &use, std::span<const glm::dvec3> weights, std::vector<std::uint32_t> &texels);
  void sampleAll(std::span<const glm::dvec3> weights, std::vector<std::uint32_t> &words);
  std::uint32_t shaded(std::uint32_t texel, const glm::dvec3 &weights) const;

  const TriangleScene &scene_;
  std::vector<std::uint32_t> constants_; ///< Each part's word, if it is one colour, else 0.
  std::uint32_t constant_ = 0;
  const MeshPart *part_ = nullptr;
  std::array<std::uint32_t, 3> vertices_{};
  bool isLoaded_ = false; ///< The rows below belong to `vertices_`.
  std::array<std::array<double, 2>, 3> uvs_{};
  std::array<std::array<double, 4>, 3> colours_{};
  std::vector<std::uint64_t> places_; ///< Of the texels in work.
  std::vector<std::uint32_t> masks_;
};

} // namespace voxc
