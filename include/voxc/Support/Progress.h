// Progress and cancellation of long work, as one object that callers may pass.
#pragma once

#include <atomic>
#include <functional>
#include <string_view>

namespace voxc {

/// How long work tells how far it is and asks whether to stop. Copies share nothing; all members are
/// optional.
struct Progress {
  /// Called now and then with the stage's name and its finished fraction in [0, 1].
  std::function<void(std::string_view stage, double fraction)> report;
  /// Set by anyone, also a signal handler, to end the work early with `ErrorKind::Interrupted`.
  const std::atomic<bool> *stop = nullptr;

  void at(std::string_view stage, double fraction) const {
    if (report)
      report(stage, fraction);
  }
  bool stopped() const { return stop && stop->load(std::memory_order_relaxed); }
};

} // namespace voxc
