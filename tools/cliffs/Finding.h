// What came out of one situation on one machine.
#pragma once

#include "Expectation.h"
#include "Measure.h"

#include "common/Json.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

namespace voxc::cliffs {

struct Finding {
  Place place;
  Situation situation;
  std::string machine;
  Cost cost;
  Expectation expected;
  double lookups = 0; ///< A ray, as counted; of instances 0.
  double exactSteps =
      0; ///< Steps, beginnings and arrivals a ray that exact arithmetic had to tell, on the cpu.
  std::uint64_t compared = 0;     ///< Rays that were compared with the oracle,
  std::uint64_t wrong = 0;        ///< and those of them that were not right.
  std::optional<double> peer;     ///< Nanoseconds of another tracer a ray.
  std::optional<double> movedOff; ///< Nanoseconds of the same rays moved off a little, a ray.

  double ratio() const { return cost.nanoseconds / expected.nanoseconds; }
  /// How far it is off beside what is nearest to it: what is expected, or the other tracer.
  double leastRatio() const { return peer ? std::min(ratio(), rayNanoseconds() / *peer) : ratio(); }
  double rayNanoseconds() const { return cost.nanoseconds / static_cast<double>(situation.count); }
};

/// A finding as a line of JSON.
tool::Json toJson(const Finding &finding);
/// Its counts as a line of a file of cases: those that are the same on every machine.
std::string caseLine(const Finding &finding);

} // namespace voxc::cliffs
