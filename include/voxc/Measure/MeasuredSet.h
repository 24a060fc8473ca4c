// Sets of rays that formats are measured by: how a record names them, and the oracle's hits of some.
#pragma once

#include "voxc/Measure/Digest.h"
#include "voxc/Measure/Record.h"
#include "voxc/Trace/Camera.h"
#include "voxc/Trace/Ray.h"
#include "voxc/Trace/RayOrder.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace voxc::measure {

struct MeasuredSet {
  RaysPart part;
  std::vector<Ray> rays;
  std::optional<Camera> camera; ///< None: they are a list.

  /// In which its rays are taken.
  RayOrder order() const;
};

/// How a record names a camera's rays; `digest` is that of the camera, without its size in pixels.
RaysPart cameraPart(const std::string &name, std::array<int, 2> size, Digest digest);
/// The same of the camera that sees a whole volume.
RaysPart overviewPart(std::array<int, 2> size);
/// The same of a list of rays, of which there is one at least.
RaysPart listPart(const std::string &name, std::span<const Ray> rays);

/// The rays of a camera that sees a whole volume of this extent.
MeasuredSet overviewSet(Int3 extent, std::array<int, 2> size);
/// A list of rays, of which there is one at least, taken in this order.
MeasuredSet listSet(const std::string &name, std::vector<Ray> rays, RayOrder order = RayOrder::Auto);

/// Rays, and some of them for the oracle, evenly spread.
struct SampledRays {
  std::vector<Ray> rays;
  std::vector<Ray> sample;
  std::vector<Hit> exact; ///< The oracle's hits of the sample, once it was asked.

  /// Those of all hits that are the sample's.
  std::vector<Hit> sampleOf(std::span<const Hit> hits) const;
};

/// With a sample of at most `count`; the oracle is still to be asked.
SampledRays sampleRays(std::vector<Ray> rays, std::size_t count);

} // namespace voxc::measure
