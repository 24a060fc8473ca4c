// The colour of a scene at points of its triangles.
#pragma once

#include "Mesh/ModelFrame.h"
#include "Mesh/Voxelize/TriangleCursor.h"
#include "voxc/Mesh/TriangleScene.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace voxc {

/// The colour of one triangle after the other, in sRGB: what `Material` says.
class SurfaceColour {
public:
  /// The scene, which is checked, must outlive this.
  explicit SurfaceColour(const TriangleScene &scene);

  /// Goes to the triangle at which `cursor` stands.
  void moveTo(const TriangleCursor &cursor);

  /// Sets `words` to those at the points with these weights, or to 0 where alpha cuts the triangle away. What
  /// remains has an alpha of at least 1, so that the word is not "empty".
  void at(std::span<const glm::dvec3> weights, std::vector<std::uint32_t> &words);

private:
  using Texels = std::vector<std::uint32_t>;
  using CornerUvs = std::array<std::array<double, 2>, 3>;

  void load();
  /// Sets `texels` to those at the points; all ones if there is no texture.
  void sample(const TextureUse &use, const CornerUvs &uvs, std::span<const glm::dvec3> weights,
              Texels &texels);
  std::uint32_t shaded(std::size_t point, const glm::dvec3 &weights) const;

  const TriangleScene &scene_;
  std::vector<std::optional<std::uint32_t>> constants_; ///< Each part's word, if it is one colour.
  std::optional<std::uint32_t> constant_;
  const MeshPart *part_ = nullptr;
  const Material *material_ = nullptr;
  bool isPlain_ = false; ///< A texel's colour is the surface's.
  std::array<std::uint32_t, 3> vertices_{};
  bool isLoaded_ = false; ///< The rows below belong to `vertices_`.
  CornerUvs uvs_{};
  CornerUvs emissionUvs_{};
  std::array<std::array<double, 4>, 3> colours_{};
  // Of the points in work.
  std::vector<std::uint64_t> places_;
  Texels texels_;
  Texels masks_;
  Texels emissions_;
};

} // namespace voxc
