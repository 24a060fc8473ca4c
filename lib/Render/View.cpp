// Cameras by a word.
#include "voxc/Render/View.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

namespace voxc {

namespace {

constexpr double kOutsideFov = 38; ///< Degrees: little perspective, as things look from some steps away.
constexpr double kInsideFov = 70;

constexpr double kMargin = 0.04; ///< Of the frame, on each side.

/// Pixels across the pictures by which a view is found.
constexpr int kProbeWidth = 192;

/// A view from outside: the direction that the eye lies in from the middle, and the way up.
struct Outlook {
  glm::dvec3 from;
  glm::dvec3 up{0, 1, 0};
};

/// From the front and the right, so that the longer side of the ground is seen at the smaller angle; the
/// flatter the scene, the more from above.
Outlook isoOutlook(const glm::dvec3 &extent) {
  const double longer = std::max(extent.x, extent.z);
  const double elevation = glm::radians(glm::mix(34.0, 14.0, std::clamp(extent.y / longer - 0.3, 0.0, 1.0)));
  const double azimuth = glm::radians(extent.x >= extent.z ? 34.0 : 56.0);
  return {{std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
           std::cos(azimuth) * std::cos(elevation)}};
}

Outlook outlookOf(View view, const glm::dvec3 &extent) {
  switch (view) {
  case View::Front:
    return {{0, std::sin(glm::radians(4.0)), std::cos(glm::radians(4.0))}};
  case View::Top:
    return {{0, 1, 0}, {0, 0, -1}};
  default:
    return isoOutlook(extent);
  }
}

glm::dvec3 vectorOf(Int3 at) { return {double(at.x), double(at.y), double(at.z)}; }

std::vector<glm::dvec3> cornersOf(const glm::dvec3 &extent) {
  std::vector<glm::dvec3> corners;
  corners.reserve(8);
  for (int corner = 0; corner < 8; ++corner)
    corners.emplace_back(corner & 1 ? extent.x : 0, corner & 2 ? extent.y : 0, corner & 4 ? extent.z : 0);
  return corners;
}

/// The corners of the voxels that a small picture of a camera shows.
Expected<std::vector<glm::dvec3>> pointsSeen(Camera camera, TraceRays trace) {
  camera.height = std::max(1, kProbeWidth * camera.height / camera.width);
  camera.width = kProbeWidth;
  const std::vector<Ray> rays = cameraRays(camera);
  std::vector<Hit> hits(rays.size());
  if (Expected<void> traced = trace(rays, hits, {}); !traced)
    return traced.error();
  std::vector<glm::dvec3> points;
  for (const Hit &hit : hits)
    if (hit.isHit()) {
      points.emplace_back(hit.voxel[0], hit.voxel[1], hit.voxel[2]);
      points.push_back(points.back() + glm::dvec3(1));
    }
  return points;
}

Expected<Camera> outsideCamera(View view, const Volume &volume, TraceRays trace, Camera camera) {
  const glm::dvec3 extent = vectorOf(volume.info().extent);
  const Outlook outlook = outlookOf(view, extent);
  camera.look = extent * 0.5;
  camera.eye = camera.look + outlook.from;
  camera.up = outlook.up;
  camera = frame(camera, cornersOf(extent));
  Expected<std::vector<glm::dvec3>> seen = pointsSeen(camera, trace);
  if (!seen)
    return seen.error();
  return seen->empty() ? camera : frame(camera, *seen);
}

/// Somewhere within, and how much of the volume it overlooks.
struct Place {
  glm::dvec3 eye{};
  glm::dvec3 direction{0, 0, -1};
  double worth = 0;
  std::size_t number = 0; ///< Among the places looked at.
};

/// Directions around a place: rings of so many each, by pitch; the last sees the sky, where there is one.
constexpr int kTurns = 24;
constexpr double kPitches[] = {-30, -8, 12, 70};
constexpr int kLevelRings = 3;
constexpr std::size_t kLevel = std::size_t(kLevelRings) * kTurns; ///< Directions of the level rings.

std::vector<glm::dvec3> probeDirections() {
  std::vector<glm::dvec3> directions;
  for (const double pitch : kPitches)
    for (int turn = 0; turn < kTurns; ++turn) {
      const double yaw = glm::radians(360.0 * turn / kTurns);
      const double level = std::cos(glm::radians(pitch));
      directions.emplace_back(level * std::sin(yaw), std::sin(glm::radians(pitch)), level * std::cos(yaw));
    }
  return directions;
}

/// Colours that differ in the upper bits of a channel, of those that are hit around a direction.
std::size_t colourVariety(const glm::dvec3 &level, std::span<const glm::dvec3> directions,
                          std::span<const Hit> hits) {
  constexpr std::uint32_t kUpperBits = 0xe0e0e0;
  std::set<std::uint32_t> colours;
  for (std::size_t i = 0; i < hits.size(); ++i)
    if (hits[i].isHit() && glm::dot(level, directions[i]) > 0.75)
      colours.insert(hits[i].rgba & kUpperBits);
  return colours.size();
}

/// The level direction around which most is seen, far off and in many colours. `hits` are those of the level
/// rings.
glm::dvec3 bestDirection(std::span<const glm::dvec3> directions, std::span<const Hit> hits) {
  glm::dvec3 chosen{0, 0, -1};
  double best = -1;
  for (int turn = 0; turn < kTurns; ++turn) {
    const glm::dvec3 level = directions[std::size_t(kTurns + turn)];
    double far = 0;
    for (std::size_t i = 0; i < hits.size(); ++i)
      if (hits[i].isHit())
        far += std::max(glm::dot(level, directions[i]) - 0.6, 0.0) * std::sqrt(double(hits[i].t));
    far *= 4 + double(colourVariety(level, directions, hits));
    if (far > best) {
      best = far;
      chosen = glm::normalize(glm::dvec3(level.x, 0.04, level.z));
    }
  }
  return chosen;
}

/// The room around a place: the distance that a quarter of the rays of the level rings do not come to.
double roomOf(std::span<const Hit> level) {
  std::vector<double> distances;
  for (const Hit &hit : level)
    distances.push_back(hit.isHit() ? double(hit.t) : 0);
  const auto quarter = distances.begin() + std::ptrdiff_t(distances.size() / 4);
  std::ranges::nth_element(distances, quarter);
  return *quarter;
}

/// A place is worth the more, the more there is around it at eye level and the more room it has. One that
/// sees the sky is worth more than a closed one.
double worthOf(std::span<const Hit> hits) {
  const auto level = hits.first(kLevel), above = hits.subspan(kLevel);
  const double share = double(std::ranges::count_if(level, &Hit::isHit)) / kLevel;
  return share * share * roomOf(level) * (std::ranges::all_of(above, &Hit::isHit) ? 1 : 2);
}

/// The best of many places, on a grid at several heights.
Expected<Place> bestPlace(const glm::dvec3 &extent, TraceRays trace) {
  const std::vector<glm::dvec3> directions = probeDirections();
  std::vector<glm::dvec3> eyes;
  constexpr int kAcross = 14;
  for (const double height : {0.1, 0.16, 0.24})
    for (int x = 1; x < kAcross; ++x)
      for (int z = 1; z < kAcross; ++z)
        eyes.push_back(extent * glm::dvec3(double(x) / kAcross, height, double(z) / kAcross) + 0.37);
  std::vector<Ray> rays;
  for (const glm::dvec3 &eye : eyes)
    for (const glm::dvec3 &direction : directions)
      rays.push_back(makeRay(eye, direction));
  std::vector<Hit> hits(rays.size());
  if (Expected<void> traced = trace(rays, hits, {}); !traced)
    return traced.error();
  const auto around = [&](std::size_t i) {
    return std::span<const Hit>(hits).subspan(i * directions.size(), directions.size());
  };
  Place best{extent * 0.5};
  for (std::size_t i = 0; i < eyes.size(); ++i)
    if (const double worth = worthOf(around(i)); worth > best.worth)
      best = {eyes[i], best.direction, worth, i};
  if (best.worth > 0)
    best.direction = bestDirection(directions, around(best.number).first(kLevel));
  return best;
}

Camera cameraAt(const Place &place, const glm::dvec3 &extent, Camera camera) {
  camera.eye = place.eye;
  camera.look = place.eye + place.direction * (0.25 * std::max({extent.x, extent.y, extent.z}));
  return camera;
}

/// The least room of a room, in parts of the longer side of the ground: a thicket has less.
constexpr double kLeastRoom = 0.04;

/// The camera inside, if the volume is a building or a yard: it has room, sees something wherever it looks,
/// and some sky, and much of what it sees lies under a roof, where no camera from above would look.
Expected<std::optional<Camera>> roomCamera(const Place &place, const glm::dvec3 &extent, TraceRays trace,
                                           const Camera &settings) {
  const std::vector<glm::dvec3> directions = probeDirections();
  std::vector<Ray> rays;
  rays.reserve(directions.size());
  for (const glm::dvec3 &direction : directions)
    rays.push_back(makeRay(place.eye, direction));
  std::vector<Hit> hits(rays.size());
  if (Expected<void> traced = trace(rays, hits, {}); !traced)
    return traced.error();
  const auto level = std::span(hits).first(kLevel);
  const auto above = std::span(hits).subspan(kLevel);
  if (std::ranges::count_if(level, &Hit::isHit) < std::ptrdiff_t(kLevel * 85 / 100) ||
      std::ranges::all_of(above, &Hit::isHit) || roomOf(level) < kLeastRoom * std::max(extent.x, extent.z))
    return std::optional<Camera>();
  std::vector<Ray> up;
  constexpr double kBefore = 0.97; // Of the way, so that a wall is not its own roof.
  for (std::size_t i = 0; i < kLevel; ++i)
    if (level[i].isHit())
      up.push_back(makeRay(place.eye + directions[i] * (kBefore * double(level[i].t)), glm::dvec3{0, 1, 0}));
  std::vector<Hit> roofs(up.size());
  if (Expected<void> traced = trace(up, roofs, {}); !traced)
    return traced.error();
  if (std::size_t(std::ranges::count_if(roofs, &Hit::isHit)) * 4 < roofs.size())
    return std::optional<Camera>();
  return std::optional<Camera>(cameraAt(place, extent, settings));
}

/// The greatest of the numbers; or, if less than a hundredth of them stand off all others by a wide gap, the
/// greatest below that.
double outermost(std::vector<double> &numbers) {
  if (numbers.empty())
    return 0;
  std::ranges::sort(numbers);
  const std::size_t count = numbers.size();
  const double most = numbers.back();
  constexpr double kGap = 0.06;
  const double gap = kGap * (most - numbers[count / 2]);
  for (std::size_t i = count - 1 - count / 100; i + 1 < count; ++i)
    if (numbers[i + 1] - numbers[i] > gap)
      return numbers[i];
  return most;
}

/// Two decimal digits are enough, so that what is printed is what was used.
glm::dvec3 rounded(const glm::dvec3 &point) {
  glm::dvec3 result;
  for (int axis = 0; axis < 3; ++axis)
    result[axis] = std::round(point[axis] * 100) / 100;
  return result;
}

} // namespace

Camera frame(Camera camera, std::span<const glm::dvec3> points) {
  const glm::dvec3 front = glm::normalize(camera.look - camera.eye);
  const glm::dvec3 right = glm::normalize(glm::cross(front, camera.up));
  const glm::dvec3 up = glm::cross(right, front);
  const double tangentY = std::tan(glm::radians(camera.verticalFov / 2)) * (1 - 2 * kMargin);
  const double tangentX = tangentY * camera.width / camera.height;
  // Each side of the frame is a plane through the eye; with the eye moved by (a, b, -c) along right, up and
  // front, a point is within if x - a <= tangent * (z + c), and so on. The greatest of each side decides.
  std::vector<double> toRight, toLeft, toTop, toBottom;
  for (const glm::dvec3 &point : points) {
    const double x = glm::dot(point, right), y = glm::dot(point, up), z = glm::dot(point, front);
    toRight.push_back(x - tangentX * z);
    toLeft.push_back(-x - tangentX * z);
    toTop.push_back(y - tangentY * z);
    toBottom.push_back(-y - tangentY * z);
  }
  const double rightmost = outermost(toRight), leftmost = outermost(toLeft);
  const double highest = outermost(toTop), lowest = outermost(toBottom);
  const double back = std::max((rightmost + leftmost) / (2 * tangentX), (highest + lowest) / (2 * tangentY));
  camera.eye = right * ((rightmost - leftmost) / 2) + up * ((highest - lowest) / 2) - front * back;
  double far = 0;
  for (const glm::dvec3 &point : points)
    far += glm::dot(point - camera.eye, front) / double(points.size());
  camera.look = camera.eye + front * far;
  return camera;
}

namespace {

Expected<Camera> findCamera(View view, const Volume &volume, TraceRays trace, const Camera &settings) {
  const auto withFov = [&](double fov) {
    Camera camera = settings;
    camera.verticalFov = settings.verticalFov > 0 ? settings.verticalFov : fov;
    return camera;
  };
  const bool isOpen = view == View::Auto;
  if (isOpen || view == View::Inside) {
    const glm::dvec3 extent = vectorOf(volume.info().extent);
    const Expected<Place> place = bestPlace(extent, trace);
    if (!place)
      return place.error();
    if (!isOpen)
      return cameraAt(*place, extent, withFov(kInsideFov));
    const auto room = roomCamera(*place, extent, trace, withFov(kInsideFov));
    if (!room)
      return room.error();
    if (*room)
      return **room;
  }
  return outsideCamera(view, volume, trace, withFov(kOutsideFov));
}

} // namespace

Expected<Camera> viewCamera(View view, const Volume &volume, TraceRays trace, int width, int height,
                            double verticalFov) {
  if (volume.info().voxels == 0)
    return Error::input("the volume has no voxels to look at");
  Camera settings;
  settings.width = width;
  settings.height = height;
  settings.verticalFov = verticalFov;
  Expected<Camera> found = findCamera(view, volume, trace, settings);
  if (!found)
    return found;
  found->eye = rounded(found->eye);
  found->look = rounded(found->look);
  return found;
}

} // namespace voxc
