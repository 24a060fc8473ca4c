// How often this program has asked for memory: every `operator new` of it counts.
#pragma once

#include <cstdint>

namespace voxc::cliffs {

/// Of all threads, since the program began.
std::uint64_t allocationsSoFar();

} // namespace voxc::cliffs
