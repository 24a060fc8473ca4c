// Writing perf's map.
#include "PerfMap.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

namespace voxc {
namespace {

std::string pathOfThisProcess() { return "/tmp/perf-" + std::to_string(::getpid()) + ".map"; }

Error cannotWrite() {
  return Error::environment("cannot write '" + pathOfThisProcess() + "' for perf: " +
                            std::generic_category().message(errno) + "; without VOXC_PERF it is not needed");
}

} // namespace

PerfMap *PerfMap::asked() {
  static PerfMap map;
  static const bool isAsked = [] {
    const char *const text = std::getenv("VOXC_PERF");
    return text && *text != '\0' && std::string_view(text) != "0";
  }();
  return isAsked ? &map : nullptr;
}

/// The folder is everyone's: what lies there under this name is followed nowhere, and taken only if it is
/// ours.
std::optional<Error> PerfMap::open() {
  ::unlink(pathOfThisProcess().c_str()); // Of an earlier process of this number.
  file_ = ::open(pathOfThisProcess().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_NOFOLLOW | O_CLOEXEC,
                 S_IRUSR | S_IWUSR);
  return file_ < 0 ? std::optional(cannotWrite()) : std::nullopt;
}

void PerfMap::add(std::uint64_t address, std::uint64_t size, std::string_view name) {
  const std::lock_guard lock(mutex_);
  if (file_ < 0 && !problem_)
    problem_ = open();
  if (problem_)
    return;
  std::array<char, 40> numbers{};
  std::snprintf(numbers.data(), numbers.size(), "%llx %llx ", static_cast<unsigned long long>(address),
                static_cast<unsigned long long>(size));
  const std::string line = numbers.data() + std::string(name) + "\n";
  if (::write(file_, line.data(), line.size()) != static_cast<::ssize_t>(line.size()))
    problem_ = cannotWrite();
}

std::optional<Error> PerfMap::problem() const {
  const std::lock_guard lock(mutex_);
  return problem_;
}

} // namespace voxc
