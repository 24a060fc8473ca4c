// A child that reads first.
#include "Assimp/TrialRead.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <fstream>
#include <new>
#include <optional>
#include <string_view>
#include <thread>

namespace voxc {

namespace {

constexpr rlim_t kMostSeconds = 120;
constexpr std::size_t kLongest = 2048;      ///< Bytes of a sentence, which a pipe takes at once.
constexpr std::string_view kSurvived = "+"; ///< Said in place of a sentence.

/// Bytes of data that this process has; 0 where the system does not tell.
std::uint64_t dataBytes() {
  std::ifstream file("/proc/self/statm");
  std::uint64_t pages = 0;
  for (int i = 0; i < 6; ++i)
    file >> pages;
  return file ? pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
}

void limit(int what, rlim_t most) {
  const rlimit limits{most, most};
  static_cast<void>(setrlimit(what, &limits));
}

/// Runs in the child, which has this one thread alone.
[[noreturn]] void runChild(const std::function<std::string()> &read, std::uint64_t memory, int pipe) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGXCPU, SIGINT, SIGTERM})
    std::signal(signal, SIG_DFL);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, kMostSeconds);
  if (const std::uint64_t data = dataBytes(); data != 0)
    limit(RLIMIT_DATA, data + memory);
  std::string sentence;
  try {
    sentence = read();
  } catch (const std::bad_alloc &) {
    sentence = "it needs more memory than a file of its size should";
  } catch (...) {
    sentence = "it cannot be read";
  }
  if (sentence.empty())
    sentence = kSurvived;
  static_cast<void>(write(pipe, sentence.data(), std::min(sentence.size(), kLongest)));
  _exit(0);
}

/// Waits for the child; its status, or nothing if it was stopped. In a program that ignores its children's
/// end there is no status, so that what the child has said must tell whether it is well.
std::optional<int> wait(pid_t child, const Progress &progress) {
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (progress.stopped()) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      return std::nullopt;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return status;
}

} // namespace

Expected<void> tryToRead(const std::function<std::string()> &read, std::uint64_t memory,
                         const Progress &progress) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0)
    return Error::environment("there is no pipe for a process that reads");
  const pid_t child = fork();
  if (child == 0)
    runChild(read, memory, ends[1]);
  close(ends[1]);
  const auto status = child < 0 ? std::optional<int>(0) : wait(child, progress);
  std::array<char, kLongest> text;
  const ssize_t length = ::read(ends[0], text.data(), text.size());
  close(ends[0]);
  const std::string said(text.data(), static_cast<std::size_t>(std::max<ssize_t>(length, 0)));
  if (child < 0)
    return Error::environment("there is no process for a trial");
  if (!status)
    return Error::interrupted();
  if (said == kSurvived)
    return {};
  if (!said.empty())
    return Error::input(said);
  return Error::input(WIFSIGNALED(*status) && WTERMSIG(*status) == SIGXCPU
                          ? "reading it takes more than 2 minutes"
                          : "the library that reads it fails at it; the file is broken");
}

} // namespace voxc
