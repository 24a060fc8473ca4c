// From what rays cost in a format to how fast they are on a device: a sum of what was counted, each part with
// the time that it takes there.
#pragma once

#include "voxc/Search/Replay.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace voxc {

/// What the time of a ray is a sum of. Some parts are taken as often as a packet has to wait for its slowest
/// ray: times `RayCost::waits` / `RayCost::turns`.
enum class SpeedTerm : std::size_t {
  Ray,            ///< Once a ray.
  Waits,          ///< `RayCost::waits`.
  Words,          ///< `RayCost::words`.
  Layers,         ///< `RayCost::layers`.
  Marches,        ///< `RayCost::marches`.
  Switches,       ///< `RayCost::switches`, as often as a packet waits.
  Lines,          ///< `RayCost::lines`, as often as a packet waits.
  FarLines,       ///< Lines, times log2(1 + the volume's bytes / 1 MiB).
  Scatter,        ///< `RayCost::scatter`.
  ScatteredLines, ///< Lines, times scatter.
  ScatteredWords, ///< Words, times scatter.
};
inline constexpr std::size_t kSpeedTerms = 11;

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

/// The model of a device as it was measured where voxc is made: of processors for "cpu" and for Vulkan's
/// devices that are one, and else of the latter. Ratios hold elsewhere better than times.
const SpeedModel &defaultSpeedModel(std::string_view device);

} // namespace voxc
