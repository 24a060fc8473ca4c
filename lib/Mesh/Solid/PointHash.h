// Hashes of corners, by which edges and triangles of a mesh find their counterparts.
#pragma once

#include "Mesh/Voxelize/SnapGrid.h"

#include <cstdint>
#include <span>

namespace voxc {

constexpr std::uint64_t scattered(std::uint64_t value) {
  value = (value ^ value >> 32) * 0xd6e8feb86659fd93;
  value = (value ^ value >> 32) * 0xd6e8feb86659fd93;
  return value ^ value >> 32;
}

/// Of corners in this order.
inline std::uint64_t hashOf(std::span<const Point64> corners) {
  std::uint64_t hash = 0;
  for (const Point64 &corner : corners)
    for (const std::int64_t coordinate : corner)
      hash = scattered(hash * 0x9e3779b97f4a7c15 + static_cast<std::uint64_t>(coordinate));
  return hash;
}

} // namespace voxc
