// One process at a time carries out a build plan, with all that it has started.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"

#include <functional>
#include <string>

namespace voxc::tool::cluster {

/// Held from `take` until this process and all processes that it has started meanwhile have ended: they
/// inherit it, and the system takes it from the dead. So who has it knows that no task of an earlier run is
/// still at work on this machine. Nothing that is written depends on it: outputs get their names when they
/// are whole, and whoever writes one writes the same bytes. It saves work that would be done twice.
class PlanLock {
public:
  /// Takes the lock of the folder of a plan's outputs; waits while another process has it, and says so once
  /// by `waits`. On a file system without locks none is taken. Errors: `Environment`, the folder takes no
  /// file; interrupted.
  static Expected<PlanLock> take(const std::string &folder, const Progress &progress,
                                 const std::function<void()> &waits);
  ~PlanLock();
  PlanLock(PlanLock &&) noexcept;
  PlanLock &operator=(PlanLock &&) = delete;

private:
  explicit PlanLock(int file) : file_(file) {}

  int file_; ///< The open file, or -1.
};

} // namespace voxc::tool::cluster
