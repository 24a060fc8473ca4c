// Signals and limits of the process.
#include "Process.h"

#include "Signature.h"

#include "voxc/IR/Limits.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <malloc.h>
#include <pthread.h>
#include <string>
#include <string_view>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

namespace voxc::tool {
namespace {

constexpr int kEnvironmentExit = 3;
/// Compilers go deep; less has been seen to end in the middle of them.
constexpr rlim_t kLeastStack = rlim_t{1} << 20;
constexpr rlim_t kDefaultStack = rlim_t{8} << 20;

/// A mapped file was cut short by another process, or its disk failed: nothing that was read can be trusted,
/// and only calls that are safe in a handler can tell.
[[noreturn]] void tellLostFile(int) {
  constexpr char kText[] = ": error: a file that is in use was cut short, or cannot be read\n";
  static_cast<void>(!::write(STDERR_FILENO, signature(), std::strlen(signature())));
  static_cast<void>(!::write(STDERR_FILENO, kText, sizeof kText - 1));
  ::_exit(kEnvironmentExit);
}

void turnSignalsIntoErrors() {
  // A closed pipe and a limit on the size of files are errors of one write, and are told as such.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGBUS, tellLostFile);
}

/// The limit of the first thread counts when its stack grows; others take theirs when they are made.
Expected<void> enlargeStack() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >= kDefaultStack)
    return {};
  limit.rlim_cur = std::min(kDefaultStack, limit.rlim_max);
  if (limit.rlim_cur < kLeastStack)
    return Error::environment("a stack of " + std::to_string(limit.rlim_max >> 10) +
                              " KiB is too small; voxc needs " + std::to_string(kLeastStack >> 10) +
                              " (ulimit -s)");
  ::setrlimit(RLIMIT_STACK, &limit);
  pthread_attr_t attributes;
  if (::pthread_attr_init(&attributes) == 0) {
    ::pthread_attr_setstacksize(&attributes, limit.rlim_cur);
    ::pthread_setattr_default_np(&attributes);
    ::pthread_attr_destroy(&attributes);
  }
  return {};
}

/// Lets the heap grow onto huge pages, where the system has them. Compilers touch some thousand small pages,
/// and the first use of each takes the system 5 to 20 microseconds: half of the time from a format to SPIR-V.
void growHeapOnHugePages() {
#ifdef __GLIBC__
  constexpr int kHeapBytes = 32 << 20;
  constexpr std::uintptr_t kHugePage = std::uintptr_t{2} << 20;
  // Blocks below this size lie on the heap, as the C library decides by itself once some of them were freed.
  ::mallopt(M_MMAP_THRESHOLD, kHeapBytes);
  ::mallopt(M_TOP_PAD, kHeapBytes);
  void *volatile block = std::malloc(kHugePage); // The heap grows by that and the bytes above.
  std::free(block);
  char *const end = static_cast<char *>(::sbrk(0));
  char *begin = end - kHeapBytes;
  begin += (kHugePage - reinterpret_cast<std::uintptr_t>(begin) % kHugePage) % kHugePage;
  ::madvise(begin, static_cast<std::size_t>(end - begin), MADV_HUGEPAGE);
#endif
}

/// Gives the three standard streams something where who started this process had closed them: else the next
/// files that are opened would get their numbers, and what is printed. Reading from them, or writing to them,
/// stays an error.
Expected<void> fillStandardStreams() {
  for (int file = 0; file < 3; ++file)
    if (::fcntl(file, F_GETFD) < 0 && ::open("/dev/null", file == 0 ? O_WRONLY : O_RDONLY) < 0)
      return Error::environment("cannot open '/dev/null': " + std::string(std::strerror(errno)));
  return {};
}

/// VOXC_MAX_LEVELS, where it is set: as many levels as formats may have.
Expected<void> setMostLevels() {
  const char *const text = std::getenv("VOXC_MAX_LEVELS");
  if (!text || !*text)
    return {};
  const std::string_view digits = text;
  std::size_t most = 0;
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), most);
  if (failure != std::errc() || end != digits.data() + digits.size() || most < 1 || most > kMostLevels)
    return Error::usage("VOXC_MAX_LEVELS is '" + std::string(digits) + "'; a format may have 1 to " +
                        std::to_string(kMostLevels) + " levels");
  allowLevels(most);
  return {};
}

} // namespace

Expected<void> prepareProcess() {
  VOXC_TRY(fillStandardStreams());
  turnSignalsIntoErrors();
  VOXC_TRY(setMostLevels());
  growHeapOnHugePages();
  return enlargeStack();
}

} // namespace voxc::tool
