// The memory that this process has on the machine, for tests of what stays within a bound.
#pragma once

#include <cstdint>
#include <fstream>

namespace voxc::test {

inline std::uint64_t residentBytes() {
  std::ifstream file("/proc/self/statm");
  std::uint64_t total = 0, resident = 0;
  file >> total >> resident;
  return resident * 4096;
}

/// What a sanitizer keeps for so many bytes that were touched, and does not give back: 0 without one.
/// ThreadSanitizer has four beside each. AddressSanitizer has one for eight, and reads it, for which some
/// kernels keep memory too.
constexpr std::uint64_t shadowBytes([[maybe_unused]] std::uint64_t touched) {
#if defined(__SANITIZE_THREAD__)
  return 4 * touched;
#elif defined(__SANITIZE_ADDRESS__)
  return touched / 8;
#else
  return 0;
#endif
}

} // namespace voxc::test
