// SIGINT and SIGTERM as a flag that long work asks for.
#include "Interrupt.h"

#include <csignal>

namespace voxc::tool {
namespace {

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set only lock-free flags");

void setFlag(int) { interrupted.store(true, std::memory_order_relaxed); }

void catchSignal(int number) {
  struct sigaction action{};
  action.sa_handler = setFlag;
  // After the first signal the default comes back, so that a second one ends even work that never asks.
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigemptyset(&action.sa_mask);
  sigaction(number, &action, nullptr);
}

} // namespace

const std::atomic<bool> &catchInterrupts() {
  static const bool installed = [] {
    catchSignal(SIGINT);
    catchSignal(SIGTERM);
    return true;
  }();
  static_cast<void>(installed);
  return interrupted;
}

} // namespace voxc::tool
