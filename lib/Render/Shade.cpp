// Pictures shaded by face.
#include "Colour.h"
#include "Trace/Rays/EntryFace.h"

#include "voxc/Render/Picture.h"

#include <algorithm>
#include <cmath>

namespace voxc {
namespace {

/// How bright a face is whose outward normal points down or up an axis: lit from above, the left and the
/// front.
constexpr float kFaceLight[3][2] = {{0.82f, 0.68f}, {0.50f, 1.00f}, {0.60f, 0.88f}};
constexpr float kInsideLight = 1;

constexpr Colour kZenith = {0.36f, 0.56f, 0.84f};
constexpr Colour kHorizon = {0.86f, 0.91f, 0.96f};
constexpr Colour kNadir = {0.46f, 0.45f, 0.44f};

/// Light on the face through which `ray` entered the voxel.
float faceLight(const Ray &ray, const Hit &hit) {
  const EntryFace face = entryFace(ray, hit);
  return face.axis < 0 ? kInsideLight : kFaceLight[face.axis][face.high];
}

/// The sky in a direction; the horizon's colour where the direction is none.
Colour sky(const Ray &ray) {
  double length = std::hypot(ray.direction[0], ray.direction[1], ray.direction[2]);
  double height = ray.direction[1] / length;
  if (!std::isfinite(height))
    return kHorizon;
  float amount = static_cast<float>(std::sqrt(std::min(std::abs(height), 1.0)));
  return mix(kHorizon, height < 0 ? kNadir : kZenith, amount);
}

} // namespace

Picture shade(std::span<const Ray> rays, std::span<const Hit> hits, int width, int height) {
  Picture picture{width, height, {}};
  picture.pixels.resize(std::size_t(width) * std::size_t(height), packColour(kHorizon));
  std::size_t count = std::min({picture.pixels.size(), rays.size(), hits.size()});
  for (std::size_t i = 0; i < count; ++i)
    picture.pixels[i] =
        packColour(hits[i].isHit() ? unpackColour(hits[i].rgba) * faceLight(rays[i], hits[i]) : sky(rays[i]));
  return picture;
}

} // namespace voxc
