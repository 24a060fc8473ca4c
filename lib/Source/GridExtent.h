// The extent of a dense grid: its text, its cells and whether it is possible.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/Geometry.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace voxc {

/// "WxHxD".
inline std::string extentText(Int3 extent) {
  return std::to_string(extent.x) + "x" + std::to_string(extent.y) + "x" + std::to_string(extent.z);
}

/// Error: an axis that has no cell, or more than 2^21.
inline Expected<void> checkGridExtent(Int3 extent) {
  constexpr std::int32_t kMaxExtent = 1 << kMaxLog2Extent;
  if (std::min({extent.x, extent.y, extent.z}) >= 1 && std::max({extent.x, extent.y, extent.z}) <= kMaxExtent)
    return {};
  return Error::input("a grid of " + extentText(extent) +
                      " cells is not possible: each axis takes 1 to 2097152");
}

/// Cells of a possible extent: at most 2^63.
inline std::uint64_t cellsOf(Int3 extent) {
  return static_cast<std::uint64_t>(extent.x) * static_cast<std::uint64_t>(extent.y) *
         static_cast<std::uint64_t>(extent.z);
}

/// The number of a cell, x fastest, then y, then z.
inline std::uint64_t cellNumber(Int3 extent, Int3 cell) {
  const std::uint64_t row = static_cast<std::uint64_t>(cell.z) * static_cast<std::uint64_t>(extent.y) +
                            static_cast<std::uint64_t>(cell.y);
  return row * static_cast<std::uint64_t>(extent.x) + static_cast<std::uint64_t>(cell.x);
}

} // namespace voxc
