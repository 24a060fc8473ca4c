// The colour of a scene at points of its triangles.
#pragma once

#include "Mesh/ModelFrame.h"
#include "Mesh/Voxelize/Footprint.h"
#include "Mesh/Voxelize/NearestPoint.h"
#include "Mesh/Voxelize/TexelBox.h"
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
  /// The scene, which is checked, and its means must outlive this.
  SurfaceColour(const TriangleScene &scene, const SceneMeans &means);

  /// Goes to the triangle at which `cursor` stands.
  void moveTo(const TriangleCursor &cursor);

  /// Is a texel of the triangle, which has its corners in voxels, finer than a voxel? Then, and if its
  /// texture has means, texels are averaged over the part of its plane that a voxel takes. What is cut out is
  /// still decided by the nearest one.
  bool measure(const NearestPoints &triangle);

  /// Sets `words` to those at the points with these weights, or to 0 where alpha cuts the triangle away. What
  /// remains has an alpha of at least 1, so that the word is not "empty". Asked after `measure`.
  void at(std::span<const glm::dvec3> weights, std::vector<std::uint32_t> &words);

private:
  using Texels = std::vector<std::uint32_t>;
  using CornerUvs = std::array<std::array<double, 2>, 3>;

  void load();
  /// Sets `texels` to those at the points; all ones if there is no texture.
  void sample(const TextureUse &use, const CornerUvs &uvs, std::span<const glm::dvec3> weights,
              Texels &texels);
  /// Where the texels of a texture are finer than voxels.
  std::optional<Footprint> footprintOf(const TextureUse &use, bool isOpaque, const CornerUvs &uvs,
                                       const NearestPoints &triangle) const;
  /// Gives the texels that are visible the colour of the mean around them.
  void average(const Footprint &footprint, const TextureUse &use, bool isOpaque,
               std::span<const glm::dvec3> weights, Texels &texels);
  std::uint32_t shaded(std::size_t point, const glm::dvec3 &weights) const;

  const TriangleScene &scene_;
  const SceneMeans &means_;
  BoxMeans boxMeans_;
  std::vector<std::optional<std::uint32_t>> constants_; ///< Each part's word, if it is one colour.
  std::optional<std::uint32_t> constant_;
  const MeshPart *part_ = nullptr;
  const Material *material_ = nullptr;
  bool isPlain_ = false; ///< A texel's colour is the surface's.
  std::array<std::uint32_t, 3> vertices_{};
  CornerUvs uvs_{};
  CornerUvs emissionUvs_{};
  std::array<std::array<double, 4>, 3> colours_{};
  std::optional<Footprint> footprint_; ///< Of the texture, and of the emission's.
  std::optional<Footprint> emissionFootprint_;
  // Of the points in work.
  std::vector<std::uint64_t> places_;
  Texels texels_;
  Texels masks_;
  Texels emissions_;
};

} // namespace voxc
