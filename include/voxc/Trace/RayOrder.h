// In which order a tracer takes its rays. Hits do not depend on it; times do.
#pragma once

#include "voxc/Trace/BoundedRay.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace voxc {

enum class RayOrder {
  /// Where the device is a processor and the rays are many and scattered, as is faster, which a tracer
  /// measures
  /// on the first rays and keeps for calls of about as many; else as given.
  Auto,
  Given,
  /// By octant of their direction, then by where they begin, then by direction: so that neighbours in a
  /// packet
  /// go through the same cells.
  Binned,
};

/// The order of that name (auto, given, binned). Precondition: it is one of them.
RayOrder rayOrderFrom(std::string_view name);

/// Whether more than a quarter of neighbouring rays, by a sample, have another octant or begin far from each
/// other in a volume whose longest edge has `edge` voxels, and there are enough of them for bins to pay.
bool areScattered(const RaySpan &rays, int edge);

/// The numbers of the rays, bin by bin and as given within a bin, found by a radix sort with so many threads
/// (at least 1). `edge`: as above. Precondition: fewer than 2^32 rays.
std::vector<std::uint32_t> binnedOrder(const RaySpan &rays, int edge, unsigned threads);

} // namespace voxc
