// Scattering 64-bit values, so that any of their bits can be taken for a hash.
#pragma once

#include <cstdint>

namespace voxc {

/// A value for each value, none twice, and 0 for 0 (the finalizer of Stafford's "Better bit mixing", Mix13).
constexpr std::uint64_t mix(std::uint64_t value) {
  value = (value ^ value >> 30) * 0xbf58476d1ce4e5b9;
  value = (value ^ value >> 27) * 0x94d049bb133111eb;
  return value ^ value >> 31;
}

} // namespace voxc
