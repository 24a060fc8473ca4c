// The Pareto frontier: formats that no other beats in both size and speed.
#pragma once

#include <span>
#include <vector>

namespace voxc::report {

struct SizeSpeed {
  double size = 0;
  double speed = 0;
};

/// For each point whether it lies on the frontier: no other is at least as small and at least as fast, and
/// better in one of the two. Equal points are all on it, or none.
std::vector<bool> paretoFrontier(std::span<const SizeSpeed> points);

} // namespace voxc::report
