// Wall-clock and processor time for reports.
#pragma once

#include <chrono>
#include <ctime>

namespace voxc {

/// Seconds since it was made.
class Stopwatch {
public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  /// Seconds of computing, over all threads of the process.
  double cpuSeconds() const { return processSeconds() - cpuStart_; }

private:
  using Clock = std::chrono::steady_clock;

  static double processSeconds() {
    timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  Clock::time_point start_ = Clock::now();
  double cpuStart_ = processSeconds();
};

} // namespace voxc
