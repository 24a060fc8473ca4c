// From what rays cost in a format to how fast they are on a device: a sum of what was counted, each part with
// the time that it takes there.
#pragma once

#include "voxc/Search/RayCostModel.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace voxc {

/// What the time of a ray is a sum of.
enum class SpeedTerm : std::size_t {
  Ray,              ///< Once a ray.
  Binning,          ///< `RayCost::binned`.
  Levels,           ///< `RayCost::levels`.
  Colours,          ///< `RayCost::colours`.
  Turns,            ///< `RayCost::turns`.
  Words,            ///< `RayCost::words`.
  Probes,           ///< `RayCost::probes`.
  Layers,           ///< `RayCost::packetLayers`.
  Trees,            ///< `RayCost::packetTrees`.
  Marches,          ///< `RayCost::marches`.
  Switches,         ///< `RayCost::switches`.
  PacketSwitches,   ///< `RayCost::packetSwitches`.
  Lines,            ///< `RayCost::lines`.
  CacheMissLatency, ///< `RayCost::waits`, times log2(1 + the volume's bytes / 1 MiB): memory is farther away.
  CacheMissLines,   ///< `RayCost::lines`, times what that logarithm is above 2: beyond what caches hold.
};
inline constexpr std::size_t kSpeedTerms = 15;

using SpeedTerms = std::array<double, kSpeedTerms>;

/// The parts of a ray's time in a volume of so many bytes, without what they cost.
SpeedTerms speedTerms(const RayCost &cost, std::uint64_t bytes);

struct SpeedModel {
  SpeedTerms nanoseconds{}; ///< Of one of each; none is below 0.

  /// Nanoseconds of CPU time a ray.
  double predict(const SpeedTerms &terms) const;
};

/// A measured ray: what it is a sum of, and what it took.
struct SpeedSample {
  SpeedTerms terms;
  double nanoseconds;
};

/// The model with the least sum of squared relative errors over the samples, none of its parts below 0 (by
/// coordinate descent). With fewer samples than terms it is drawn towards `prior`.
SpeedModel fitSpeedModel(std::span<const SpeedSample> samples, const SpeedModel &prior = {});

/// The model of a device as measured where voxc is made: of processors for "cpu" and for Vulkan's
/// devices that are one, and else of the latter. Ratios hold elsewhere better than times.
const SpeedModel &defaultSpeedModel(std::string_view device);

} // namespace voxc
