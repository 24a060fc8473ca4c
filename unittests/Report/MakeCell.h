// Made-up cells for the tests of the report.
#pragma once

#include "report/Cells.h"

#include <string>
#include <utility>
#include <vector>

namespace voxc::report {

/// Rounds about a median, from the slowest to the fastest by a share of it.
inline tool::bench::Speed makeSpeed(double median, double spread) {
  return {median * (1 - spread / 2), median, median * (1 + spread / 2), spread};
}

/// A measured cell with this size and speed, and all of its errors looked for.
inline Cell makeCell(const std::string &format, std::uint64_t bytes, double speed,
                     std::vector<std::string> passes = {}) {
  Cell cell;
  cell.model.name = "hut";
  cell.format.name = format;
  cell.format.passes = std::move(passes);
  cell.resolution = 2048;
  cell.precision = "exact";
  cell.device = {"llvmpipe (LLVM)", "vulkan", "Mesa", 2, "cpu"};
  cell.rays = {"front", "camera", 100, {}, ""};
  cell.volume.bytes = bytes;
  cell.speed.mraysPerCpuS = makeSpeed(speed, 0.02);
  cell.error.rays = 1000;
  cell.error.missed = cell.error.ghost = cell.error.wrong = 0;
  return cell;
}

inline Cell makeFailure(const std::string &format, const std::string &reason) {
  Cell cell = makeCell(format, 0, 0);
  cell.volume = {};
  cell.speed = {};
  cell.failure = tool::bench::Failure{"build", reason, 12345};
  return cell;
}

} // namespace voxc::report
