// Posters. How large one is, style.css works out of what stands here as page-runtime/script/camera.js does.
#include "page/Poster.h"

#include "common/SmallPicture.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace voxc::page {
namespace {

/// Colours of the edge, from top to bottom.
constexpr int kStops = 9;

/// Characters that the picture takes at most: of a small page, and of any; and the share of those between.
constexpr std::size_t kLeast = 12000, kMost = 60000, kShare = 50;

bool isInside(const Camera &camera, Int3 extent) {
  if (camera.isOrthographic())
    return false;
  for (int axis = 0; axis < 3; ++axis)
    if (camera.eye[axis] < 0 || camera.eye[axis] >= extent[axis])
      return false;
  return true;
}

/// The width that a picture of height 1 must have to show all of the volume's box, and no more than the
/// camera's own.
double widthOfBox(const Camera &camera, Int3 extent) {
  constexpr double kMargin = 1.04;
  const glm::dvec3 eye = camera.eye * camera.spacing;
  const glm::dvec3 front = glm::normalize(camera.look * camera.spacing - eye);
  const glm::dvec3 right = glm::normalize(glm::cross(front, camera.up));
  const double tangent = std::tan(glm::radians(camera.verticalFov) / 2);
  const double most = double(camera.width) / camera.height;
  double wide = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 place(corner & 1 ? extent.x : 0, corner & 2 ? extent.y : 0, corner & 4 ? extent.z : 0);
    const glm::dvec3 way = place * camera.spacing - eye;
    const double half =
        camera.isOrthographic() ? camera.orthographicHeight / 2 : glm::dot(way, front) * tangent;
    wide = std::max(wide, half > 0 ? std::abs(glm::dot(way, right)) / half * kMargin : most);
  }
  return std::min(wide, most);
}

/// "#8494a3 calc(50% - 0.75*var(--half))" and so on, joined by commas.
std::string gradientOf(const Picture &picture) {
  std::string text;
  for (int stop = 0; stop < kStops; ++stop) {
    const int row = stop * (picture.height - 1) / (kStops - 1);
    const std::uint32_t pixel = picture.pixels[std::size_t(row) * std::size_t(picture.width)];
    char part[64];
    std::snprintf(part, sizeof part, "%s#%02x%02x%02x calc(50%% + %g*var(--half))", stop > 0 ? "," : "",
                  pixel & 255, pixel >> 8 & 255, pixel >> 16 & 255, 2.0 * stop / (kStops - 1) - 1);
    text += part;
  }
  return text;
}

} // namespace

std::string posterHtml(const Picture &picture, const Camera &camera, Int3 extent, std::size_t pageBytes) {
  const std::string address = tool::pictureAddress(picture, std::clamp(pageBytes / kShare, kLeast, kMost));
  if (address.empty())
    return {};
  char wide[32];
  std::snprintf(wide, sizeof wide, "--wide:%.4g;", widthOfBox(camera, extent));
  return "<div id=\"poster\"><div style=\"" + std::string(wide) + "background:linear-gradient(" +
         gradientOf(picture) + ")\"><img alt=\"\"" + (isInside(camera, extent) ? " class=\"inside\"" : "") +
         " src=\"" + address + "\"></div></div>\n";
}

} // namespace voxc::page
