// The two clocks of a measurement: wall time, and the CPU time of the whole process with all its threads.
#pragma once

#include <ctime>

namespace voxc {

inline double clockSeconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

inline double wallSeconds() { return clockSeconds(CLOCK_MONOTONIC); }
inline double processCpuSeconds() { return clockSeconds(CLOCK_PROCESS_CPUTIME_ID); }

} // namespace voxc
