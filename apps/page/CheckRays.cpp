// Rays whose hits a page knows.
#include "page/CheckRays.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace voxc::page {
namespace {

/// Scatters a number over all others.
std::uint32_t noise(std::uint32_t number) {
  for (int i = 0; i < 3; ++i)
    number = (number ^ number >> 15) * 0x9e3779b1u + 1;
  return number ^ number >> 15;
}

/// From 0 to 1, a multiple of 2^-24: products with the sides of volumes are exact.
double share(std::uint32_t number) { return (noise(number) >> 8) / 16777216.0; }

} // namespace

std::vector<Ray> checkRays(Int3 extent, std::size_t count) {
  std::vector<Ray> rays(count);
  for (std::uint32_t i = 0; i < count; ++i)
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const double side = extent[static_cast<int>(axis)];
      const double from = share(8 * i + axis) * 2 * side - side / 2;
      const double to = share(8 * i + 4 + axis) * side;
      rays[i].origin[axis] = static_cast<float>(from);
      rays[i].direction[axis] = static_cast<float>(to - from);
    }
  return rays;
}

PictureView viewOf(const Camera &camera) {
  const auto inVoxels = [&](const glm::dvec3 &v) { return glm::dvec3(glm::vec3(v / camera.spacing)); };
  const double high = shownHeight(camera, 1) / 2;
  const auto [front, right, up] = axesOf(camera);
  return {glm::dvec3(glm::vec3(camera.eye)), inVoxels(front),
          inVoxels(right * (high * camera.width / camera.height)), inVoxels(up * high),
          camera.isOrthographic()};
}

Ray rayAt(const PictureView &view, double across, double above) {
  Ray ray;
  for (int axis = 0; axis < 3; ++axis) {
    // In the order of page-runtime/script/rays.js.
    const double from = view.isParallel ? view.eye[axis] : view.front[axis];
    const double aside = from + view.right[axis] * across + view.up[axis] * above;
    ray.origin[axis] = static_cast<float>(view.isParallel ? aside : view.eye[axis]);
    ray.direction[axis] = static_cast<float>(view.isParallel ? view.front[axis] : aside);
  }
  return ray;
}

std::vector<Ray> pictureRays(const PictureView &view, std::size_t count) {
  const auto place = [](std::uint32_t number) { return (noise(number) >> 20) / 2048.0 - 1; };
  std::vector<Ray> rays(count);
  for (std::uint32_t i = 0; i < count; ++i)
    rays[i] = rayAt(view, place(2 * i), place(2 * i + 1));
  return rays;
}

std::string digestsOf(std::span<const Hit> hits) {
  std::string digests;
  for (const Hit &hit : hits) {
    std::uint32_t digest = 0;
    for (const std::int32_t coordinate : hit.voxel)
      digest = noise(digest ^ static_cast<std::uint32_t>(coordinate));
    digests += static_cast<char>(noise(digest ^ hit.rgba) & 255);
  }
  return digests;
}

} // namespace voxc::page
