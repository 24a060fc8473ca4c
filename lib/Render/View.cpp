// Cameras by a word.
#include "voxc/Render/View.h"

#include "Rooms.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace voxc {

namespace {

constexpr double kOutsideFov = 38; ///< Degrees: little perspective, as things look from some steps away.
constexpr double kInsideFov = 70;

/// Pixels along the longer side of the pictures by which a view is found: one of the whole box, and one of
/// what it shows.
constexpr int kProbeSide = 192;
constexpr int kCloseSide = 448;
/// The close one shows more than the frame, so that what lies beyond its edges is seen too.
constexpr double kBeyond = 1.2;

/// A view from outside: the direction that the eye lies in from the middle, and the way up.
struct Outlook {
  glm::dvec3 from;
  glm::dvec3 up{0, 1, 0};
};

/// From the front and the right, so that the longer side of the ground is seen at the smaller angle; the
/// flatter the scene, the more from above.
Outlook isoOutlook(const glm::dvec3 &sides) {
  const double longer = std::max(sides.x, sides.z);
  const double elevation = glm::radians(glm::mix(34.0, 14.0, std::clamp(sides.y / longer - 0.3, 0.0, 1.0)));
  const double azimuth = glm::radians(sides.x >= sides.z ? 34.0 : 56.0);
  return {{std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
           std::cos(azimuth) * std::cos(elevation)}};
}

/// From a side a little from above, so that the ground shows; by parallel rays exactly from the side, as
/// plans are drawn.
Outlook sideOutlook(const glm::dvec3 &side, bool isParallel) {
  const double elevation = glm::radians(isParallel ? 0.0 : 4.0);
  return {side * std::cos(elevation) + glm::dvec3(0, std::sin(elevation), 0)};
}

Outlook outlookOf(View view, const glm::dvec3 &sides, bool isParallel) {
  switch (view) {
  case View::Front:
    return sideOutlook({0, 0, 1}, isParallel);
  case View::Back:
    return sideOutlook({0, 0, -1}, isParallel);
  case View::Left:
    return sideOutlook({-1, 0, 0}, isParallel);
  case View::Right:
    return sideOutlook({1, 0, 0}, isParallel);
  case View::Top:
    return {{0, 1, 0}, {0, 0, -1}};
  case View::Bottom:
    return {{0, -1, 0}, {0, 0, 1}};
  default:
    return isoOutlook(sides);
  }
}

glm::dvec3 vectorOf(Int3 at) { return {double(at.x), double(at.y), double(at.z)}; }

/// Adds the corners of a box.
void addCorners(const glm::dvec3 &low, const glm::dvec3 &sides, std::vector<glm::dvec3> &corners) {
  for (int corner = 0; corner < 8; ++corner)
    corners.push_back(low + sides * glm::dvec3(corner & 1 ? 1 : 0, corner & 2 ? 1 : 0, corner & 4 ? 1 : 0));
}

/// The camera with a frame that is so many times as wide and as high.
Camera widened(Camera camera, double times) {
  camera.orthographicHeight *= times;
  camera.verticalFov = 2 * glm::degrees(std::atan(times * std::tan(glm::radians(camera.verticalFov / 2))));
  return camera;
}

/// The camera with so many pixels along the longer side.
Camera resized(Camera camera, int longer) {
  const int before = std::max(camera.width, camera.height);
  camera.width = std::max(1, longer * camera.width / before);
  camera.height = std::max(1, longer * camera.height / before);
  return camera;
}

/// Adds the voxels that a picture of a camera shows, so many pixels along its longer side.
Expected<void> addVoxelsSeen(const Camera &whole, int longer, TraceRays trace,
                             std::vector<std::array<std::int32_t, 3>> &voxels) {
  const Camera camera = resized(whole, longer);
  const std::vector<Ray> rays = cameraRays(camera);
  std::vector<Hit> hits(rays.size());
  VOXC_TRY(trace(rays, hits, {}));
  for (const Hit &hit : hits)
    if (hit.isHit())
      voxels.push_back({hit.voxel[0], hit.voxel[1], hit.voxel[2]});
  std::ranges::sort(voxels);
  const auto rest = std::ranges::unique(voxels);
  voxels.erase(rest.begin(), rest.end());
  return {};
}

/// What a picture of the whole box shows is brought into the frame; from there, nearer, more of it is seen,
/// and that is brought into the frame too. What is thinner than a pixel of the second may be missed by less
/// than the margin.
Expected<Camera> outsideCamera(View view, const Volume &volume, TraceRays trace, Camera camera) {
  const glm::dvec3 extent = vectorOf(volume.info().extent);
  const Outlook outlook = outlookOf(view, extent * camera.spacing, camera.isOrthographic());
  camera.look = extent * 0.5;
  camera.eye = camera.look + outlook.from / camera.spacing;
  camera.up = outlook.up;
  std::vector<glm::dvec3> corners;
  addCorners(glm::dvec3(0), extent, corners);
  camera = frame(camera, corners);
  std::vector<std::array<std::int32_t, 3>> voxels;
  for (const bool isClose : {false, true}) {
    const Camera probe = isClose ? widened(camera, kBeyond) : camera;
    if (Expected<void> seen =
            addVoxelsSeen(probe, isClose ? int(kCloseSide * kBeyond) : kProbeSide, trace, voxels);
        !seen)
      return seen.error();
    if (voxels.empty())
      break;
    corners.clear();
    for (const auto &[x, y, z] : voxels)
      addCorners({double(x), double(y), double(z)}, glm::dvec3(1), corners);
    camera = frame(camera, corners);
  }
  return camera;
}

Camera cameraAt(const Place &place, const glm::dvec3 &extent, Camera camera) {
  const glm::dvec3 sides = extent * camera.spacing;
  camera.eye = place.eye;
  camera.look = place.eye + place.direction * (0.25 * std::max({sides.x, sides.y, sides.z})) / camera.spacing;
  return camera;
}

/// Two decimal digits are enough, so that what is printed is what was used.
double rounded(double number) { return std::round(number * 100) / 100; }

glm::dvec3 rounded(const glm::dvec3 &point) { return {rounded(point.x), rounded(point.y), rounded(point.z)}; }

Expected<FoundView> foundView(View view, const Volume &volume, TraceRays trace, const Camera &like) {
  const auto withFov = [&](double fov) {
    Camera camera = like;
    camera.verticalFov = like.verticalFov > 0 ? like.verticalFov : fov;
    return camera;
  };
  if (view == View::Inside || (view == View::Auto && !like.isOrthographic())) {
    const glm::dvec3 extent = vectorOf(volume.info().extent);
    const auto place = VOXC_TRY(bestPlace(extent, like.spacing, trace));
    const auto isRoom =
        VOXC_TRY(view == View::Inside ? Expected<bool>(true) : isInRoom(place, extent, like.spacing, trace));
    if (isRoom)
      return FoundView{cameraAt(place, extent, withFov(kInsideFov)), View::Inside};
  }
  const View outside = view == View::Auto ? View::Iso : view;
  const Expected<Camera> camera = outsideCamera(outside, volume, trace, withFov(kOutsideFov));
  return camera ? Expected<FoundView>(FoundView{*camera, outside}) : camera.error();
}

} // namespace

Expected<FoundView> findView(View view, const Volume &volume, TraceRays trace, const Camera &like) {
  if (volume.info().voxels == 0)
    return Error::input("the volume has no voxels to look at");
  if (view == View::Inside && like.isOrthographic())
    return Error::usage(
        "an orthographic camera sees nothing from inside; look from outside, and cut away what is before it");
  auto found = VOXC_TRY(foundView(view, volume, trace, like));
  found.camera.eye = rounded(found.camera.eye);
  found.camera.look = rounded(found.camera.look);
  found.camera.orthographicHeight = rounded(found.camera.orthographicHeight);
  return found;
}

Expected<Camera> viewCamera(View view, const Volume &volume, TraceRays trace, int width, int height,
                            double verticalFov) {
  Camera like;
  like.width = width;
  like.height = height;
  like.verticalFov = verticalFov;
  like.spacing = spacingOf(volume.info().voxelToModel);
  const Expected<FoundView> found = findView(view, volume, trace, like);
  return found ? Expected<Camera>(found->camera) : found.error();
}

} // namespace voxc
