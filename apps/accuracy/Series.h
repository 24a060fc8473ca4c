// Series: speed and error of variants against the distance of the origin, and against the resolution.
#pragma once

#include "accuracy/Variant.h"

#include <span>
#include <vector>

namespace voxc::tool {

/// How one variant did.
struct Score {
  double mraysPerCpuSecond = 0;
  ErrorFigures error;
};

/// All variants at one place of a series, in their order.
struct SeriesPoint {
  double at = 0; ///< Voxels: the distance, or the side of the volume.
  std::vector<Score> scores;
};

struct SeriesOptions {
  std::size_t rays = 0;
  unsigned rounds = 0;
  unsigned threads = 0;
  Progress progress;
};

/// Rays from 1, 10, ... 10^9 voxels outside the sphere around a volume, from all sides to random points
/// inside. The candidates' own findings are replaced.
Expected<std::vector<SeriesPoint>>
distanceSeries(std::span<const std::unique_ptr<VariantCandidate>> candidates, const Oracle &oracle,
               Int3 extent, const SeriesOptions &options);

/// Volumes of 2^4, 2^5, ... 2^16 voxels an axis in the format "R(3^3) G(n - 3)", each with the same number of
/// single voxels strewn over it, and rays from the sphere around it to random points of these.
Expected<std::vector<SeriesPoint>> resolutionSeries(const VariantChoice &choice, measure::Devices &devices,
                                                    const SeriesOptions &options);

} // namespace voxc::tool
