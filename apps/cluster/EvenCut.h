// Cutting a row of costs into runs of about the same cost.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace voxc::tool::cluster {

/// The ends of `count` runs (at least 1) that cover `costs` from the first to the last: the largest cost of a
/// run is the least that is possible. Runs at the end may be empty where there are fewer costs than runs. The
/// sum of all costs is less than 2^63.
std::vector<std::uint64_t> cutEvenly(std::span<const std::uint64_t> costs, std::uint64_t count);

} // namespace voxc::tool::cluster
