// Cameras in voxel space, and the rays through their pixels.
#include "voxc/Trace/Camera.h"
#include "voxc/Trace/PixelRays.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace voxc {
namespace {

/// The unit vector along `v`, or `fallback` if `v` has no direction.
glm::dvec3 normalized(const glm::dvec3 &v, const glm::dvec3 &fallback) {
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v * (1 / length) : fallback;
}

CameraAxes axesAlong(glm::dvec3 direction, glm::dvec3 up) {
  CameraAxes view;
  view.front = normalized(direction, {0, 0, -1});
  // Looking along `up` leaves the roll open: the axis furthest from the view decides it then.
  glm::dvec3 spare = std::abs(view.front[2]) < 0.5 ? glm::dvec3{0, 0, 1} : glm::dvec3{1, 0, 0};
  glm::dvec3 right = glm::cross(view.front, normalized(up, {0, 1, 0}));
  constexpr double kParallel = 1e-9;
  view.right = glm::dot(right, right) > kParallel * kParallel
                   ? normalized(right, {1, 0, 0})
                   : normalized(glm::cross(view.front, spare), {1, 0, 0});
  view.up = glm::cross(view.right, view.front);
  return view;
}

/// How far behind the centre of a box with these half sides a camera must stand to see all of its corners.
double framingDistance(const CameraAxes &view, glm::dvec3 half, double tangentX, double tangentY) {
  double distance = 0;
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec3 point = {corner & 1 ? half[0] : -half[0], corner & 2 ? half[1] : -half[1],
                        corner & 4 ? half[2] : -half[2]};
    double depth = glm::dot(point, view.front);
    distance = std::max({distance, std::abs(glm::dot(point, view.right)) / tangentX - depth,
                         std::abs(glm::dot(point, view.up)) / tangentY - depth});
  }
  return distance;
}

double tangentOf(const Camera &camera) { return std::tan(glm::radians(camera.verticalFov / 2)); }

} // namespace

glm::dvec3 spacingOf(const Transform &voxelToModel) {
  constexpr double kEqual = 1e-5; // Scans hold their spacing in float32, often turned by a quaternion.
  constexpr double kMost = 10000; // Beyond that a picture shows a line.
  glm::dvec3 sides;
  for (int axis = 0; axis < 3; ++axis)
    sides[axis] = glm::length(voxelToModel[axis]);
  const double least = std::min({sides.x, sides.y, sides.z});
  for (int axis = 0; axis < 3; ++axis)
    if (!(sides[axis] > 0 && sides[axis] <= least * kMost))
      return glm::dvec3(1);
  for (int axis = 0; axis < 3; ++axis)
    sides[axis] = sides[axis] <= least * (1 + kEqual) ? 1 : sides[axis] / least;
  return sides;
}

Camera frameExtent(Int3 extent, int width, int height) {
  constexpr glm::dvec3 kFromCorner = {0.62, 0.48, 0.9};
  constexpr double kMargin = 1.04;
  Camera camera;
  camera.width = width;
  camera.height = height;
  camera.look = glm::dvec3{double(extent.x), double(extent.y), double(extent.z)} * 0.5;
  const CameraAxes view = axesAlong(-kFromCorner, camera.up);
  double tangent = std::tan(glm::radians(camera.verticalFov / 2));
  double distance = framingDistance(view, camera.look, tangent * width / height, tangent);
  camera.eye = camera.look - view.front * (distance * kMargin);
  return camera;
}

Camera cameraFromAngles(Int3 extent, glm::dvec3 position, double pitch, double yaw, double verticalFov,
                        int width, int height, const glm::dvec3 &spacing) {
  const glm::dvec3 sides = glm::dvec3(extent.x, extent.y, extent.z) * spacing;
  const double scale = std::max({sides.x, sides.y, sides.z}) / 100.0;
  double p = glm::radians(pitch);
  double y = glm::radians(yaw);
  glm::dvec3 front = {std::cos(p) * std::sin(y), std::sin(p), std::cos(p) * std::cos(y)};
  Camera camera;
  camera.eye = position * scale / spacing;
  camera.look = camera.eye + front / spacing;
  camera.spacing = spacing;
  camera.verticalFov = verticalFov;
  camera.width = width;
  camera.height = height;
  return camera;
}

Camera cameraFromView(const glm::dmat4 &view, double verticalFov, int width, int height) {
  const glm::dmat4 toVoxels = glm::inverse(view);
  Camera camera;
  camera.eye = toVoxels[3];
  camera.look = camera.eye - glm::dvec3(toVoxels[2]);
  camera.up = toVoxels[1];
  camera.verticalFov = verticalFov;
  camera.width = width;
  camera.height = height;
  return camera;
}

CameraAxes axesOf(const Camera &camera) {
  return axesAlong((camera.look - camera.eye) * camera.spacing, camera.up * camera.spacing);
}

double pixelSpread(const Camera &camera) {
  return camera.isOrthographic() ? 0 : 2 * tangentOf(camera) / camera.height;
}

double shownHeight(const Camera &camera, double distance) {
  return camera.isOrthographic() ? camera.orthographicHeight : 2 * tangentOf(camera) * distance;
}

double lookDistance(const Camera &camera) { return glm::length((camera.look - camera.eye) * camera.spacing); }

Camera projected(const Camera &camera, bool isOrthographic) {
  if (camera.isOrthographic() == isOrthographic)
    return camera;
  Camera other = camera;
  const double distance = lookDistance(camera);
  other.orthographicHeight = isOrthographic ? shownHeight(camera, distance) : 0;
  if (!isOrthographic && distance > 0)
    other.eye = camera.look +
                (camera.eye - camera.look) * (camera.orthographicHeight / (2 * tangentOf(camera) * distance));
  return other;
}

std::vector<Ray> cameraRays(const Camera &camera) { return cameraRays(camera, 0, camera.height, {0.5, 0.5}); }

PixelRays::PixelRays(const Camera &camera, glm::dvec2 place)
    : eye_(camera.eye), spacing_(camera.spacing), isOrthographic_(camera.isOrthographic()) {
  const CameraAxes axes = axesOf(camera);
  const double high = isOrthographic_ ? camera.orthographicHeight / 2 : tangentOf(camera);
  const double aspect = double(camera.width) / camera.height;
  front_ = axes.front;
  for (int column = 0; column < camera.width; ++column)
    across_.push_back(axes.right * (high * aspect * (2 * (column + place.x) / camera.width - 1)));
  for (int row = 0; row < camera.height; ++row)
    down_.push_back(axes.up * (high * (1 - 2 * (row + place.y) / camera.height)));
}

Ray PixelRays::through(int column, int row) const {
  const glm::dvec3 &across = across_[std::size_t(column)], &down = down_[std::size_t(row)];
  if (isOrthographic_)
    return makeRay(eye_ + (across + down) / spacing_, front_ / spacing_);
  return makeRay(eye_, normalized(front_ + across + down, front_) / spacing_);
}

std::vector<Ray> cameraRays(const Camera &camera, int firstRow, int rows, glm::dvec2 place) {
  const PixelRays pixels(camera, place);
  std::vector<Ray> rays;
  rays.reserve(std::size_t(std::max(camera.width, 0)) * std::size_t(std::max(rows, 0)));
  for (int row = firstRow; row < firstRow + rows; ++row)
    for (int column = 0; column < camera.width; ++column)
      rays.push_back(pixels.through(column, row));
  return rays;
}

} // namespace voxc
