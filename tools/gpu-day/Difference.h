// How far the hits of a device are from the oracle's.
#pragma once

#include "common/Json.h"
#include "voxc/Trace/Ray.h"

#include <cstdint>
#include <span>

namespace voxc::gpu {

struct Difference {
  std::uint64_t missed = 0, ghost = 0; ///< The oracle hits, the device does not; the other way round.
  std::uint64_t wrong = 0;             ///< Another voxel.
  std::uint64_t colour = 0;            ///< The right voxel with another word.
  std::uint64_t maxUlp = 0;            ///< Of t, where both hit the same voxel.

  std::uint64_t count() const { return missed + ghost + wrong + colour; }
  tool::Json toJson() const;
};

/// Compares all hits, one by one. Precondition: there are as many of both.
Difference differenceOf(std::span<const Hit> hits, std::span<const Hit> exact);

} // namespace voxc::gpu
