// The rays through the pixels of a picture, one at a time and in any order.
#pragma once

#include "voxc/Trace/Camera.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace voxc {

/// The rays of a camera through the place of each pixel that `place` says, as `cameraRays` makes them.
class PixelRays {
public:
  PixelRays(const Camera &camera, glm::dvec2 place);

  /// That of a pixel, rows from the top.
  Ray through(int column, int row) const;

private:
  glm::dvec3 eye_;
  glm::dvec3 front_;
  glm::dvec3 spacing_;
  bool isOrthographic_;
  std::vector<glm::dvec3> across_; ///< Of each column, from the picture's middle to it, by unit of `front_`;
  std::vector<glm::dvec3> down_;   ///< and of each row.
};

} // namespace voxc
