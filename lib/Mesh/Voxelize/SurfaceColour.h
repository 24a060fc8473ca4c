// The colour of a scene at points of its triangles.
#pragma once

#include "Mesh/ModelFrame.h"
#include "Mesh/Voxelize/TriangleCursor.h"
#include "voxc/Mesh/TriangleScene.h"

#include <array>
#include <cstdint>
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

  /// The word at the point with these weights, or 0 where texture and mask cut the triangle away. What
  /// remains has the alpha of the material and the vertices, but at least 1, so that the word is not "empty".
  std::uint32_t at(const Double3 &weights) { return constant_ != 0 ? constant_ : varied(weights); }

  /// True if `at` is the same everywhere on the triangle, and not 0.
  bool isConstant() const { return constant_ != 0; }

private:
  std::uint32_t varied(const Double3 &weights);
  void load();

  const TriangleScene &scene_;
  std::vector<std::uint32_t> constants_; ///< Each part's word, if it is one colour, else 0.
  std::uint32_t constant_ = 0;
  const MeshPart *part_ = nullptr;
  std::array<std::uint32_t, 3> vertices_{};
  bool isLoaded_ = false; ///< The rows below belong to `vertices_`.
  std::array<std::array<double, 2>, 3> uvs_{};
  std::array<std::array<double, 4>, 3> colours_{};
};

} // namespace voxc
