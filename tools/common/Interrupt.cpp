// SIGINT, SIGTERM and SIGHUP as a flag that long work asks for, and the end of work that does not.
#include "Interrupt.h"

#include "Signature.h"

#include <csignal>
#include <cstring>
#include <unistd.h>

namespace voxc::tool {
namespace {

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set only lock-free flags");

constexpr unsigned kPatienceSeconds = 1;
constexpr int kInterruptedExit = 130;

void setFlag(int) {
  interrupted.store(true, std::memory_order_relaxed);
  ::alarm(kPatienceSeconds);
}

/// Work that has not asked by now, such as a driver's compiler, is not waited for. Output has no name yet, so
/// nothing is left of it.
[[noreturn]] void giveUp(int) {
  constexpr char kText[] = ": error: interrupted\n";
  static_cast<void>(!::write(STDERR_FILENO, signature(), std::strlen(signature())));
  static_cast<void>(!::write(STDERR_FILENO, kText, sizeof kText - 1));
  ::_exit(kInterruptedExit);
}

void catchSignal(int number, void (*handler)(int)) {
  struct sigaction action{};
  action.sa_handler = handler;
  // After the first signal the default comes back, so that a second one ends the process at once.
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigemptyset(&action.sa_mask);
  sigaction(number, &action, nullptr);
}

/// Whoever starts a process that shall outlive its terminal (nohup) has it ignore this signal.
void catchUnlessIgnored(int number, void (*handler)(int)) {
  struct sigaction before{};
  if (::sigaction(number, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
    catchSignal(number, handler);
}

} // namespace

const std::atomic<bool> &catchInterrupts() {
  static const bool installed = [] {
    catchSignal(SIGALRM, giveUp);
    catchSignal(SIGINT, setFlag);
    catchSignal(SIGTERM, setFlag);
    catchUnlessIgnored(SIGHUP, setFlag);
    return true;
  }();
  static_cast<void>(installed);
  return interrupted;
}

void heedInterrupt() { ::alarm(0); }

} // namespace voxc::tool
