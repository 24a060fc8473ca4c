// Cameras that have everything in the frame.
#include "voxc/Render/View.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace voxc {

namespace {

constexpr double kMargin = 0.04; ///< Of the frame, on each side.

/// The greatest of the numbers; or, if less than a hundredth of them stand off all others by as much as all
/// others are apart, the greatest of these: a picture of a speck and of a thing that is half as large is
/// none.
double outermost(std::vector<double> &numbers) {
  if (numbers.empty())
    return 0;
  const std::size_t few = numbers.size() / 100 + 1;
  const auto top = numbers.end() - std::ptrdiff_t(std::min(few, numbers.size()));
  std::ranges::nth_element(numbers, top);
  std::sort(top, numbers.end());
  const double least = *std::ranges::min_element(numbers);
  for (auto at = top; at + 1 < numbers.end(); ++at)
    if (*(at + 1) - *at > std::max(*at - least, kMargin))
      return *at;
  return numbers.back();
}

/// How far points reach to the four sides of a picture: the greatest of each decides.
struct Reach {
  double right, left, top, bottom;
};

/// Each side of the frame is a plane through the eye, or along the view if `tangent` is 0; with the eye moved
/// by (a, b, -c) along right, up and front, a point is within if x - a <= tangent * (z + c), and so on.
Reach reachOf(std::span<const glm::dvec3> points, const CameraAxes &axes, const glm::dvec2 &tangent) {
  std::vector<double> toRight, toLeft, toTop, toBottom;
  for (const glm::dvec3 &point : points) {
    const double x = glm::dot(point, axes.right), y = glm::dot(point, axes.up);
    const double z = glm::dot(point, axes.front);
    toRight.push_back(x - tangent.x * z);
    toLeft.push_back(-x - tangent.x * z);
    toTop.push_back(y - tangent.y * z);
    toBottom.push_back(-y - tangent.y * z);
  }
  return {outermost(toRight), outermost(toLeft), outermost(toTop), outermost(toBottom)};
}

} // namespace

Camera frame(Camera camera, std::span<const glm::dvec3> points) {
  if (points.empty())
    return camera;
  const CameraAxes axes = axesOf(camera);
  std::vector<glm::dvec3> spaced;
  spaced.reserve(points.size());
  double nearest = INFINITY, far = 0;
  for (const glm::dvec3 &point : points) {
    spaced.push_back(point * camera.spacing);
    nearest = std::min(nearest, glm::dot(spaced.back(), axes.front));
    far += glm::dot(spaced.back(), axes.front) / double(points.size());
  }
  const double aspect = double(camera.width) / camera.height;
  constexpr double kWithin = 1 - 2 * kMargin;
  const bool isParallel = camera.isOrthographic();
  const double tangentY = isParallel ? 0 : shownHeight(camera, 1) / 2 * kWithin;
  const double tangentX = tangentY * aspect;
  const Reach reach = reachOf(spaced, axes, {tangentX, tangentY});
  const double wide = reach.right + reach.left, high = reach.top + reach.bottom;
  double depth = 0; // Of the eye, along the view.
  if (isParallel) {
    camera.orthographicHeight = std::max({high, wide / aspect, 1e-3}) / kWithin;
    depth = nearest - std::max(far - nearest, camera.orthographicHeight);
  } else {
    depth = -std::max(wide / (2 * tangentX), high / (2 * tangentY));
  }
  const glm::dvec3 eye = axes.right * ((reach.right - reach.left) / 2) +
                         axes.up * ((reach.top - reach.bottom) / 2) + axes.front * depth;
  camera.eye = eye / camera.spacing;
  camera.look = (eye + axes.front * (far - depth)) / camera.spacing;
  return camera;
}

} // namespace voxc
