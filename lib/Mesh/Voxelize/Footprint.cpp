// Lengths of gradients.
#include "Mesh/Voxelize/Footprint.h"

#include "Mesh/Voxelize/CornerRows.h"
#include "Mesh/Voxelize/TexelPlace.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace voxc {

Footprint::Footprint(const TextureMeans &means, const TextureUse &use,
                     const std::array<std::array<double, 2>, 3> &uvs,
                     const std::array<glm::dvec3, 2> &gradients)
    : means_(&means) {
  constexpr double kFar = 0x1p40;
  const std::array<int, 2> sizes{means.width(), means.height()};
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const std::array<double, 2> mapped = mappedUv(use, uvs[corner]);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      corners_[corner][axis] = mapped[axis] * sizes[axis];
      if (!(std::abs(corners_[corner][axis]) < kFar))
        return;
    }
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double first = corners_[0][axis];
    const double second = corners_[1][axis];
    const double third = corners_[2][axis];
    const glm::dvec3 gradient = (second - first) * gradients[0] + (third - first) * gradients[1];
    half_[axis] = glm::length(gradient) / 2;
    bounds_.low[axis] = std::min({first, second, third});
    bounds_.high[axis] = std::max({first, second, third});
    isFiner_ = isFiner_ || half_[axis] > 0.5;
  }
}

TexelBox Footprint::at(const glm::dvec3 &weights) const {
  const std::array<double, 2> centre = mixed(corners_, weights);
  TexelBox box;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    box.low[axis] = std::max(centre[axis] - half_[axis], bounds_.low[axis]);
    box.high[axis] = std::min(centre[axis] + half_[axis], bounds_.high[axis]);
  }
  return box;
}

} // namespace voxc
