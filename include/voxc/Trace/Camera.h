// Cameras in voxel space, and the rays through their pixels.
#pragma once

#include "voxc/Support/Geometry.h"
#include "voxc/Support/Transform.h"
#include "voxc/Trace/Ray.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace voxc {

/// Where a picture is taken from. `eye` and `look` are points in voxels, `up` is a direction there, which
/// need not be orthogonal to the view.
///
/// Voxels of a scan need not be cubes. The picture is taken in *spaced* space: that of voxels, stretched by
/// `spacing` along its axes. Angles, distances and t are of that space; rays are given in voxels all the
/// same.
struct Camera {
  glm::dvec3 eye{};
  glm::dvec3 look{};
  glm::dvec3 up{0, 1, 0};
  double verticalFov = 60; ///< Degrees, in (0, 180). An orthographic camera does not use it.
  int width = 1280;
  int height = 720;
  glm::dvec3 spacing{1}; ///< Sides of a voxel, above 0; as `spacingOf` gives them, or 1 for cubes.
  /// Of an orthographic camera: what its picture shows from bottom to top, above 0, in spaced space; its rays
  /// are parallel and begin in the plane of the eye. 0: the camera is a pinhole.
  double orthographicHeight = 0;

  bool isOrthographic() const { return orthographicHeight > 0; }
};

/// The sides of a voxel that become those of the model by `voxelToModel`, relative to the least: 1, 1, 3 for
/// a scan of 0.5 x 0.5 x 1.5 mm. Exactly 1 where they are equal up to the rounding of files, and where the
/// transform has no sides that a picture could show (a side that is 0 or not finite, or 10000 times another).
glm::dvec3 spacingOf(const Transform &voxelToModel);

/// A camera that sees all of a box of voxels from above a corner.
Camera frameExtent(Int3 extent, int width, int height);

/// A camera given as in cameras.json: position in a volume scaled to [0, 100]^3 by its longest axis in spaced
/// space, yaw and pitch in degrees.
Camera cameraFromAngles(Int3 extent, glm::dvec3 position, double pitch, double yaw, double verticalFov,
                        int width, int height, const glm::dvec3 &spacing = glm::dvec3(1));

/// The camera of a view matrix, which takes voxel space to the camera's: x to the right, y up, looking along
/// -z. The matrix must have an inverse.
Camera cameraFromView(const glm::dmat4 &view, double verticalFov, int width, int height);

/// The axes of a camera in spaced space: unit vectors, orthogonal to each other.
struct CameraAxes {
  glm::dvec3 front, right, up;
};
CameraAxes axesOf(const Camera &camera);

/// The width of a pixel at the picture's centre, per unit of distance from the eye; 0 of an orthographic
/// camera, whose pixels do not grow.
double pixelSpread(const Camera &camera);

/// What a picture shows from bottom to top, in spaced space, so far in front of the eye.
double shownHeight(const Camera &camera, double distance);

/// From the eye to the point looked at, in spaced space.
double lookDistance(const Camera &camera);

/// The same picture of what lies around the point looked at, by parallel rays or, with `isOrthographic`
/// false, by those of a pinhole. A pinhole moves to where it shows as much of the plane of that point.
Camera projected(const Camera &camera, bool isOrthographic);

/// One ray a pixel, rows from the top. In spaced space directions are unit length up to rounding; where
/// spacing is 1 they are in voxels too.
std::vector<Ray> cameraRays(const Camera &camera);

/// The rays of some rows from `firstRow` on, through the place of each pixel that `place` says: (0, 0) is its
/// top left corner, (1, 1) the opposite one.
std::vector<Ray> cameraRays(const Camera &camera, int firstRow, int rows, glm::dvec2 place);

} // namespace voxc
