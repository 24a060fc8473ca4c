// Unnamed files by Linux, and how they take the place of what has their name.
#include "UnnamedFile.h"

#include "Path.h"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace voxc::platform {
namespace {

/// The name beside is taken for the time between two system calls.
constexpr int kAttempts = 10000;
constexpr useconds_t kPauseMicroseconds = 1000;

/// Permissions before the process's mask.
constexpr mode_t modeOf(Access access) { return access == Access::Owner ? 0600 : 0666; }

/// A link to the open file itself.
std::string linkOf(int file) { return "/proc/self/fd/" + std::to_string(file); }

bool linkAs(int file, const std::string &path) {
  return ::linkat(AT_FDCWD, linkOf(file).c_str(), AT_FDCWD, path.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

/// Where a file waits to take the place of `path`, locked by its process: always by the same name, so that
/// what a killed process leaves there is found by the next one.
std::string besideName(const std::string &path) {
  constexpr std::size_t kMostBytes = 200; // A name has 255 at most.
  return folderOf(path) + "/." + path.substr(lastPart(path)).substr(0, kMostBytes) + ".voxc-new";
}

bool isSame(int file, const std::string &path) {
  struct stat opened{};
  struct stat named{};
  return ::fstat(file, &opened) == 0 && ::stat(path.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
         opened.st_dev == named.st_dev;
}

/// Removes the file beside if no process has it locked, and else waits for a moment.
void clearBeside(const std::string &beside) {
  const int file = ::open(beside.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (file < 0)
    return;
  if (::flock(file, LOCK_EX | LOCK_NB) != 0)
    ::usleep(kPauseMicroseconds);
  else if (isSame(file, beside)) // Else its process has just given it its name.
    ::unlink(beside.c_str());
  ::close(file);
}

/// mkostemp makes a file private; others shall have the permissions of an ordinary one.
void makeOrdinary(int file) {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  ::fchmod(file, modeOf(Access::Ordinary) & ~mask);
}

} // namespace

int openUnnamed(const std::string &path, Access access) {
  return ::open(folderOf(path).c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, modeOf(access));
}

bool hasNoUnnamed(int error) { return error == EOPNOTSUPP || error == EISDIR || error == EINVAL; }

bool canBeNamed(int file) { return ::access(linkOf(file).c_str(), F_OK) == 0; }

bool giveName(int file, const std::string &path) {
  if (linkAs(file, path))
    return true;
  if (errno != EEXIST)
    return false;
  const std::string beside = besideName(path);
  ::flock(file, LOCK_EX);
  for (int attempt = 0; !linkAs(file, beside); ++attempt) {
    if (errno != EEXIST || attempt == kAttempts)
      return false;
    clearBeside(beside);
  }
  if (::rename(beside.c_str(), path.c_str()) == 0)
    return true;
  const int error = errno;
  ::unlink(beside.c_str());
  errno = error;
  return false;
}

int openNew(std::string &path, Access access) {
  path += ".XXXXXX";
  const int file = ::mkostemp(path.data(), O_CLOEXEC);
  if (file >= 0 && access == Access::Ordinary)
    makeOrdinary(file);
  return file;
}

} // namespace voxc::platform
