// Rays from the surfaces of a band to the sun and the sky.
#pragma once

#include "Film.h"
#include "Surface.h"
#include "Tiles.h"

#include "voxc/Render/Render.h"

#include <glm/vec3.hpp>

#include <span>

namespace voxc {

/// What the rays of one sample of a film have met; both in the order of their tiles.
struct MetSurfaces {
  std::span<const Hit> hits;
  std::span<const Surface> surfaces; ///< Those of misses mean nothing.
};

class LightRays {
public:
  /// `sun` is a unit vector in spaced space, `openScale` that of `openness`, `samples` how many a pixel
  /// takes.
  LightRays(TraceRays trace, const glm::vec3 &sun, const glm::vec3 &spacing, float openScale,
            unsigned samples)
      : trace_(trace), sun_(sun), spacing_(spacing), openScale_(openScale), samples_(samples) {}

  /// Adds the sun's light on what faces it and sees it. Errors: those of tracing.
  Expected<void> addSun(Film &film, const MetSurfaces &met, const TraceOptions &options) const;
  /// Adds what a ray from each hit to somewhere in the sky brings. Errors: those of tracing.
  Expected<void> addSky(Film &film, unsigned sample, const MetSurfaces &met,
                        const TraceOptions &options) const;

private:
  template <TileOrder kOrder, typename RayOf, typename Take>
  Expected<void> send(const Film &film, const TraceOptions &options, const RayOf &rayOf,
                      const Take &take) const;

  TraceRays trace_;
  glm::vec3 sun_;
  glm::vec3 spacing_;
  float openScale_;
  unsigned samples_;
};

} // namespace voxc
