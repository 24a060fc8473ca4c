// Running a child process.
#include "jobs/Child.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace voxc::tool {
namespace {

constexpr int kPollMilliseconds = 50;
constexpr std::size_t kKeptErrorBytes = 16384;
constexpr int kInterruptedExit = 130;
/// An interrupt of a terminal reaches a child and this process, which may hear of it a moment later.
constexpr int kSameInterruptMilliseconds = 200;

Error cannotStart() {
  return Error::environment(std::string("cannot start a process: ") + std::strerror(errno));
}

/// A pipe whose ends no other child inherits.
class Pipe {
public:
  Pipe() {
    if (::pipe2(ends_, O_CLOEXEC) != 0)
      ends_[0] = ends_[1] = -1;
  }
  ~Pipe() {
    closeEnd(0);
    closeEnd(1);
  }
  Pipe(const Pipe &) = delete;
  Pipe &operator=(const Pipe &) = delete;

  bool isOpen() const { return ends_[0] >= 0; }
  int readEnd() const { return ends_[0]; }
  int writeEnd() const { return ends_[1]; }
  void closeWriteEnd() { closeEnd(1); }

private:
  void closeEnd(int which) {
    if (ends_[which] >= 0)
      ::close(std::exchange(ends_[which], -1));
  }

  int ends_[2];
};

/// A program to be started.
struct Program {
  const char *path;
  bool writesOutput; ///< To the standard output of this process.
};

/// What the new process does; only calls that are safe after a fork of several threads.
[[noreturn]] void becomeChild(const Program &program, char *const *arguments, int errorEnd, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) // It ended before that could be asked for.
    ::_exit(1);
  const int nothing = ::open("/dev/null", O_RDWR);
  ::dup2(nothing, STDIN_FILENO);
  if (!program.writesOutput)
    ::dup2(nothing, STDOUT_FILENO);
  ::dup2(errorEnd, STDERR_FILENO);
  ::execv(program.path, arguments);
  ::_exit(127);
}

/// Takes what the child writes until it closes its end; true when it has.
bool drain(int end, std::string &text) {
  pollfd waiting{end, POLLIN, 0};
  if (::poll(&waiting, 1, kPollMilliseconds) <= 0)
    return false;
  char buffer[4096];
  const ssize_t count = ::read(end, buffer, sizeof buffer);
  if (count < 0)
    return errno != EINTR;
  text.append(buffer, static_cast<std::size_t>(count));
  if (text.size() > kKeptErrorBytes)
    text.erase(0, text.size() - kKeptErrorBytes);
  return count == 0;
}

/// The last line of a text that says something, without the program's name.
std::string lastLine(std::string text) {
  constexpr std::string_view kPrefix = "voxc: error: ";
  text.erase(text.find_last_not_of(" \n\r") + 1);
  text.erase(0, text.rfind('\n') + 1);
  return text.starts_with(kPrefix) ? text.substr(kPrefix.size()) : text;
}

/// Has this process been stopped, or is it now?
bool isStoppedSoon(const Progress &progress) {
  for (int waited = 0; !progress.stopped() && waited < kSameInterruptMilliseconds; waited += 10)
    ::poll(nullptr, 0, 10);
  return progress.stopped();
}

std::string failureOf(int status, const std::string &errors) {
  if (WIFSIGNALED(status)) {
    const int number = WTERMSIG(status);
    return "the process was ended by signal " + std::to_string(number) + " (" + ::strsignal(number) + ")" +
           (number == SIGKILL ? "; the machine may have run out of memory" : "");
  }
  const std::string line = lastLine(errors);
  return line.empty() ? "the process ended with exit code " + std::to_string(WEXITSTATUS(status)) : line;
}

/// Starts a program whose first word is its name, and waits for its end.
Expected<ChildReport> runToEnd(const Program &program, std::vector<std::string> words,
                               const Progress &progress, const std::function<void()> &poll) {
  std::vector<char *> argv;
  argv.reserve(words.size() + 1);
  for (std::string &word : words)
    argv.push_back(word.data());
  argv.push_back(nullptr);
  Pipe errors;
  if (!errors.isOpen())
    return cannotStart();
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child < 0)
    return cannotStart();
  if (child == 0)
    becomeChild(program, argv.data(), errors.writeEnd(), parent);
  errors.closeWriteEnd();
  std::string text;
  while (!drain(errors.readEnd(), text) && !progress.stopped())
    poll();
  if (progress.stopped()) {
    ::kill(child, SIGTERM);
    ::kill(child, SIGCONT); // One that is halted hears nothing else.
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR)
    ;
  const bool wasInterrupted = WIFEXITED(status) && WEXITSTATUS(status) == kInterruptedExit;
  if (progress.stopped() || (wasInterrupted && isStoppedSoon(progress)))
    return Error::interrupted();
  ChildReport report{.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1, .errors = text};
  report.succeeded = report.exitCode == 0;
  if (!report.succeeded)
    report.failure = failureOf(status, text);
  return report;
}

} // namespace

Expected<ChildReport> runChild(const std::vector<std::string> &arguments, const Progress &progress,
                               const std::function<void()> &poll) {
  std::vector<std::string> words{"voxc"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return runToEnd({"/proc/self/exe", false}, std::move(words), progress, poll);
}

Expected<ChildReport> runProgram(const std::vector<std::string> &words, const Progress &progress) {
  return runToEnd({words.front().c_str(), true}, words, progress, [] {});
}

} // namespace voxc::tool
