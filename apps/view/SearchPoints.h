// What a search or a sweep measured, as points of size and speed that the viewer can load.
#pragma once

#include "voxc/Measure/Record.h"
#include "voxc/Support/Error.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace voxc::view {

/// A format with its passes, as measured.
struct SearchPoint {
  std::string text;       ///< As `FormatText` reads it.
  double bytes = 0;       ///< Of its volume.
  double mraysPerS = 0;   ///< Of the mean time over all sets of rays, in what the device's clock counts.
  bool isLeading = false; ///< No other is at least as small and as fast.
};

/// All that was measured of the first record's model, device and precision, in the order of bytes. A format
/// that lacks a set of rays which another one has is left out, for its mean would be one of other rays.
struct SearchPoints {
  std::vector<SearchPoint> points;
  std::string device, model;

  /// The number of the point of this format; none if it was not measured.
  std::optional<std::size_t> find(const std::string &text) const;
  /// The leading point that is next to `from` in size, `step` (1 or -1) further; from none, the first or
  /// last.
  std::optional<std::size_t> nextLeading(std::optional<std::size_t> from, int step) const;
};

/// Reads the records of a folder of `voxc search` or `voxc bench`. Errors: those of reading; no record that
/// was measured.
Expected<SearchPoints> readSearchPoints(const std::string &folder);
SearchPoints makeSearchPoints(std::span<const measure::Record> records);

} // namespace voxc::view
