// LAS files: points of laser scans.
#pragma once

#include "Input/Points/PointList.h"
#include "voxc/Support/Error.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace voxc {

/// What the head of a file says of its points.
struct LasHeader {
  int minor = 0;                       ///< Of version 1.0 to 1.4.
  unsigned format = 0;                 ///< Of points, 0 to 10.
  std::uint64_t count = 0;             ///< Of points, which are all there.
  std::uint64_t stride = 0;            ///< Bytes of a point.
  std::uint64_t records = 0;           ///< Of variable length, before and behind the points.
  std::uint64_t behind = 0;            ///< Bytes behind the last point, where nothing may stand.
  std::span<const std::byte> points{}; ///< The first of `count * stride` bytes.
  std::array<double, 3> scale{};
  std::array<double, 3> offset{};

  /// The same fields lie in two orders.
  bool isNew() const { return format >= 6; }
};

/// Errors: no LAS file of version 1.0 to 1.4; compressed points; a format that is not known; points that are
/// not all there; scales and offsets that are no numbers.
Expected<LasHeader> readLasHeader(std::span<const std::byte> bytes);

/// The points of a file, which are looked through once. `header` points into bytes that must outlive them.
/// Colours are those of the file; without any, greys of the intensity; without that, white. What is withheld
/// is no point. Error: interrupted.
Expected<std::unique_ptr<PointList>> readLasPoints(const LasHeader &header, WorkingMemory &memory,
                                                   const Progress &progress);

} // namespace voxc
