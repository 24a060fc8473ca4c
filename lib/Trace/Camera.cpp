// A pinhole camera in voxel space, and the rays through its pixels.
#include "voxc/Trace/Camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace voxc {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

Double3 operator+(Double3 a, Double3 b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Double3 operator-(Double3 a, Double3 b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Double3 operator*(Double3 a, double s) { return {a[0] * s, a[1] * s, a[2] * s}; }
double dot(Double3 a, Double3 b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Double3 cross(Double3 a, Double3 b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The unit vector along `v`, or `fallback` if `v` has no direction.
Double3 normalize(Double3 v, Double3 fallback) {
  double length = std::sqrt(dot(v, v));
  return length > 0 && std::isfinite(length) ? v * (1 / length) : fallback;
}

/// The axes of a view: unit vectors, orthogonal to each other.
struct View {
  Double3 front;
  Double3 right;
  Double3 up;
};

View viewOf(Double3 direction, Double3 up) {
  View view;
  view.front = normalize(direction, {0, 0, -1});
  // Looking along `up` leaves the roll open: the axis furthest from the view decides it then.
  Double3 spare = std::abs(view.front[2]) < 0.5 ? Double3{0, 0, 1} : Double3{1, 0, 0};
  Double3 right = cross(view.front, normalize(up, {0, 1, 0}));
  constexpr double kParallel = 1e-9;
  view.right = dot(right, right) > kParallel * kParallel ? normalize(right, {1, 0, 0})
                                                         : normalize(cross(view.front, spare), {1, 0, 0});
  view.up = cross(view.right, view.front);
  return view;
}

/// How far behind the centre of a box with these half sides a camera must stand to see all of its corners.
double framingDistance(const View &view, Double3 half, double tangentX, double tangentY) {
  double distance = 0;
  for (int corner = 0; corner < 8; ++corner) {
    Double3 point = {corner & 1 ? half[0] : -half[0], corner & 2 ? half[1] : -half[1],
                     corner & 4 ? half[2] : -half[2]};
    double depth = dot(point, view.front);
    distance = std::max({distance, std::abs(dot(point, view.right)) / tangentX - depth,
                         std::abs(dot(point, view.up)) / tangentY - depth});
  }
  return distance;
}

} // namespace

Camera frameExtent(Int3 extent, int width, int height) {
  constexpr Double3 kFromCorner = {0.62, 0.48, 0.9};
  constexpr double kMargin = 1.04;
  Camera camera;
  camera.width = width;
  camera.height = height;
  camera.look = Double3{double(extent.x), double(extent.y), double(extent.z)} * 0.5;
  View view = viewOf(kFromCorner * -1, camera.up);
  double tangent = std::tan(camera.verticalFov / 2 * kRadians);
  double distance = framingDistance(view, camera.look, tangent * width / height, tangent);
  camera.eye = camera.look - view.front * (distance * kMargin);
  return camera;
}

Camera cameraFromAngles(Int3 extent, Double3 position, double pitch, double yaw, double verticalFov,
                        int width, int height) {
  double scale = std::max({extent.x, extent.y, extent.z}) / 100.0;
  double p = pitch * kRadians;
  double y = yaw * kRadians;
  Double3 front = {std::cos(p) * std::sin(y), std::sin(p), std::cos(p) * std::cos(y)};
  Camera camera;
  camera.eye = position * scale;
  camera.look = camera.eye + front;
  camera.verticalFov = verticalFov;
  camera.width = width;
  camera.height = height;
  return camera;
}

double pixelSpread(const Camera &camera) {
  return 2 * std::tan(camera.verticalFov / 2 * kRadians) / camera.height;
}

std::vector<Ray> cameraRays(const Camera &camera) {
  View view = viewOf(camera.look - camera.eye, camera.up);
  double tangent = std::tan(camera.verticalFov / 2 * kRadians);
  double aspect = double(camera.width) / camera.height;
  std::vector<Ray> rays;
  rays.reserve(std::size_t(std::max(camera.width, 0)) * std::size_t(std::max(camera.height, 0)));
  for (int row = 0; row < camera.height; ++row) {
    double y = tangent * (1 - 2 * (row + 0.5) / camera.height);
    for (int column = 0; column < camera.width; ++column) {
      double x = tangent * aspect * (2 * (column + 0.5) / camera.width - 1);
      Double3 direction = normalize(view.front + view.right * x + view.up * y, view.front);
      Ray ray;
      std::ranges::copy(camera.eye, ray.origin);
      std::ranges::copy(direction, ray.direction);
      rays.push_back(ray);
    }
  }
  return rays;
}

} // namespace voxc
