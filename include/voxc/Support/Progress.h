// Progress and cancellation of long work, as one object that callers may pass.
#pragma once

#include "voxc/Support/Error.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <string_view>

namespace voxc {

/// How long work reports how far it is and asks whether to stop. Copies share nothing; all members are
/// optional.
struct Progress {
  /// Called now and then with the stage's name, its finished fraction in [0, 1], and how many things are done
  /// (voxels, triangles, rays); 0: it does not count.
  std::function<void(std::string_view stage, double fraction, std::uint64_t done)> report;
  /// Set by anyone, also a signal handler, to end the work early with `ErrorKind::Interrupted`.
  const std::atomic<bool> *stop = nullptr;
  /// Asked besides, as often as the work looks whether to stop, and by several threads at once; true ends the
  /// work in the same way, and has to be followed by true. For deadlines that nobody sets a flag for.
  std::function<bool()> ask;

  void at(std::string_view stage, double fraction, std::uint64_t done = 0) const {
    if (report)
      report(stage, fraction, done);
  }
  bool stopped() const { return (stop && stop->load(std::memory_order_relaxed)) || (ask && ask()); }
  /// The error that ends work which is to stop: `VOXC_TRY(progress.check());`.
  Expected<void> check() const {
    if (stopped())
      return Error::interrupted();
    return {};
  }
  /// The same without reports, for work of other threads.
  Progress silent() const { return {{}, stop, ask}; }
};

} // namespace voxc
