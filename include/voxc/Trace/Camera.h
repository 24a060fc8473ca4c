// A pinhole camera in voxel space, and the rays through its pixels.
#pragma once

#include "voxc/Support/Geometry.h"
#include "voxc/Trace/Ray.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace voxc {

/// Where a picture is taken from. `look` is a point; `up` need not be orthogonal to the view.
struct Camera {
  glm::dvec3 eye{};
  glm::dvec3 look{};
  glm::dvec3 up{0, 1, 0};
  double verticalFov = 60; ///< Degrees, in (0, 180).
  int width = 1280;
  int height = 720;
};

/// A camera that sees all of a box of voxels from above a corner.
Camera frameExtent(Int3 extent, int width, int height);

/// A camera given as in cameras.json: position in a volume scaled to [0, 100]^3 by its longest axis, yaw and
/// pitch in degrees.
Camera cameraFromAngles(Int3 extent, glm::dvec3 position, double pitch, double yaw, double verticalFov,
                        int width, int height);

/// The camera of a view matrix, which takes voxel space to the camera's: x to the right, y up, looking along
/// -z. The matrix must have an inverse.
Camera cameraFromView(const glm::dmat4 &view, double verticalFov, int width, int height);

/// The width of a pixel at the picture's centre, per unit of distance from the eye.
double pixelSpread(const Camera &camera);

/// One ray a pixel, rows from the top; directions are unit length up to rounding.
std::vector<Ray> cameraRays(const Camera &camera);

/// The rays of some rows from `firstRow` on, through the place of each pixel that `place` says: (0, 0) is its
/// top left corner, (1, 1) the opposite one.
std::vector<Ray> cameraRays(const Camera &camera, int firstRow, int rows, glm::dvec2 place);

} // namespace voxc
