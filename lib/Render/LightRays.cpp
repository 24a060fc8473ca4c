// Rays to the sun and the sky.
#include "LightRays.h"

#include "Exposure.h"
#include "Lighting.h"

#include <glm/geometric.hpp>

#include <optional>
#include <vector>

namespace voxc {

namespace {

/// Where light goes: to which pixel of the film, from which of its rays.
struct LitPixel {
  std::uint32_t ray;
  std::uint32_t pixel;
};

} // namespace

/// Sends the ray of each pixel that `rayOf` gives one, in this order, and tells `take` what it met.
template <TileOrder kOrder, typename RayOf, typename Take>
Expected<void> LightRays::send(const Film &film, const TraceOptions &options, const RayOf &rayOf,
                               const Take &take) const {
  std::vector<Ray> rays;
  std::vector<LitPixel> from;
  Tiles(film.width, film.rows).visitAll<kOrder>([&](const TiledPixel &at) {
    if (const std::optional<Ray> ray = rayOf(at)) {
      rays.push_back(*ray);
      from.push_back({at.ray, at.pixel});
    }
  });
  std::vector<Hit> hits(rays.size());
  VOXC_TRY(trace_(rays, hits, options));
  for (std::size_t k = 0; k < from.size(); ++k)
    take(from[k], hits[k]);
  return {};
}

Expected<void> LightRays::addSun(Film &film, const MetSurfaces &met, const TraceOptions &options) const {
  const auto rayOf = [&](const TiledPixel &at) -> std::optional<Ray> {
    const Surface &surface = met.surfaces[at.ray];
    if (!met.hits[at.ray].isHit() || !(glm::dot(surface.normal, sun_) > 0))
      return std::nullopt;
    return makeRay(surface.start, sun_ / spacing_);
  };
  return send<TileOrder::Near>(film, options, rayOf, [&](const LitPixel &at, const Hit &shadow) {
    if (!shadow.isHit())
      film.pixels[at.pixel].light +=
          linearColour(met.hits[at.ray].rgba) * kSunLight * glm::dot(met.surfaces[at.ray].normal, sun_);
  });
}

Expected<void> LightRays::addSky(Film &film, unsigned sample, const MetSurfaces &met,
                                 const TraceOptions &options) const {
  constexpr std::uint32_t kDirections = kSkyPattern * kSkyPattern;
  const auto rayOf = [&](const TiledPixel &at) -> std::optional<Ray> {
    if (!met.hits[at.ray].isHit())
      return std::nullopt;
    const std::uint32_t pattern = skyPattern(at.column, film.firstRow + at.row);
    const std::uint32_t number =
        isSkySpread(samples_) ? sample * kDirections + pattern : pattern * samples_ + sample;
    const Surface &surface = met.surfaces[at.ray];
    return makeRay(surface.start, skyDirection(surface.normal, evenNumbers(number)) / spacing_);
  };
  return send<TileOrder::Alike>(film, options, rayOf, [&](const LitPixel &at, const Hit &hidden) {
    film.pixels[at.pixel].sky += openness(hidden, openScale_);
  });
}

} // namespace voxc
