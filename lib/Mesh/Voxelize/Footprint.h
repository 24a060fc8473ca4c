// How much of a texture a voxel takes on a triangle.
#pragma once

#include "Mesh/ModelFrame.h"
#include "Mesh/Voxelize/TexelBox.h"

#include <array>

namespace voxc {

/// A box as long, along each axis of the texture, as its coordinate changes over the length of a voxel; no
/// larger than the triangle.
class Footprint {
public:
  /// The means must outlive this. `uvs` are the corners' coordinates, and `gradients` those of the weights of
  /// the second and third corner, for each voxel.
  Footprint(const TextureMeans &means, const TextureUse &use, const std::array<std::array<double, 2>, 3> &uvs,
            const std::array<glm::dvec3, 2> &gradients);

  /// Is a texel smaller than a voxel? No, if coordinates are not finite or the triangle has no area.
  bool isFiner() const { return isFiner_; }

  const TextureMeans &means() const { return *means_; }

  /// The box around a point by its weights.
  TexelBox at(const glm::dvec3 &weights) const;

private:
  const TextureMeans *means_;
  std::array<std::array<double, 2>, 3> corners_; ///< In texels.
  std::array<double, 2> half_{};                 ///< Half the lengths of the box.
  TexelBox bounds_{};                            ///< Of the triangle.
  bool isFiner_ = false;
};

} // namespace voxc
