// Files by POSIX.
#include "File.h"

#include "Path.h"

#include <cerrno>
#include <climits>
#include <fcntl.h>
#include <linux/magic.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

namespace voxc::platform {
namespace {

PathKind kindOf(const struct stat &status) {
  return S_ISREG(status.st_mode)   ? PathKind::File
         : S_ISDIR(status.st_mode) ? PathKind::Folder
                                   : PathKind::Other;
}

/// As many as the system follows.
constexpr int kMostLinks = 40;

/// Links of /proc are no names: they have a text, but lead to what a process has open.
bool isOfProcesses(const std::string &link) {
  struct statfs system{};
  return ::statfs(folderOf(link).c_str(), &system) == 0 && system.f_type == PROC_SUPER_MAGIC;
}

constexpr mode_t kPermissions = 0777;

/// Permissions that give a group what all others have.
mode_t forOthers(mode_t mode) { return (mode & (S_IRWXU | S_IRWXO)) | (mode & S_IRWXO) << 3; }

/// What a link says; nothing if there is no link.
std::optional<std::string> linkAt(const std::string &path) {
  char text[PATH_MAX];
  const ssize_t size = ::readlink(path.c_str(), text, sizeof text);
  return size < 0 ? std::nullopt
                  : std::optional<std::string>(std::in_place, text, static_cast<std::size_t>(size));
}

} // namespace

PathKind kindOf(const std::string &path) {
  struct stat status{};
  return ::stat(path.c_str(), &status) == 0 ? kindOf(status) : PathKind::Nothing;
}

std::optional<LinkEnd> followLinks(const std::string &path) {
  struct stat status{};
  // The system may forbid to follow a link of another user that may be read.
  if (linkAt(path) && ::stat(path.c_str(), &status) != 0 && errno != ENOENT)
    return std::nullopt;
  LinkEnd end{path};
  for (int links = 0; links <= kMostLinks; ++links) {
    const auto link = linkAt(end.path);
    if (!link)
      return end;
    end.isOpen = isOfProcesses(end.path);
    if (end.isOpen)
      return end;
    end.path = link->starts_with('/') ? *link : folderOf(end.path) + "/" + *link;
  }
  errno = ELOOP;
  return std::nullopt;
}

std::optional<FileStatus> statusOf(int file) {
  struct stat status{};
  if (::fstat(file, &status) != 0)
    return std::nullopt;
  return FileStatus{kindOf(status), static_cast<std::uint64_t>(status.st_size)};
}

int openToRead(const std::string &path) { return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK); }

int openToWrite(const std::string &path) {
  const int end = kindOf(path) == PathKind::File ? O_APPEND : 0; // A device would be at its end with that.
  return ::open(path.c_str(), O_WRONLY | O_CLOEXEC | end);
}

void close(int file) { ::close(file); }

std::FILE *streamTo(int file) { return ::fdopen(file, "wb"); }

int fileOf(std::FILE *stream) { return ::fileno(stream); }

bool writeAt(int file, std::span<const std::byte> bytes, std::uint64_t offset) {
  while (!bytes.empty()) { // A disk that fills up, or a limit, may take a part before it refuses the rest.
    const ssize_t written = ::pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR)
      continue;
    if (written <= 0)
      return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    offset += static_cast<std::uint64_t>(written);
  }
  return true;
}

bool extendTo(int file, std::uint64_t bytes) {
  const auto status = statusOf(file);
  return status && (status->bytes >= bytes || ::ftruncate(file, static_cast<off_t>(bytes)) == 0);
}

bool writeThrough(int file) { return ::fdatasync(file) == 0; }

bool renameOver(const std::string &from, const std::string &to) {
  return ::rename(from.c_str(), to.c_str()) == 0;
}

bool removeFile(const std::string &path) { return ::unlink(path.c_str()) == 0; }

bool takeAccessOf(const std::string &path, int file) {
  struct stat status{};
  if (::stat(path.c_str(), &status) != 0)
    return errno == ENOENT; // Someone else has removed it.
  // Before the permissions, which a new owner may take away. Most processes may not, and own what they make.
  if (::fchown(file, status.st_uid, status.st_gid) != 0)
    static_cast<void>(::fchown(file, static_cast<uid_t>(-1), status.st_gid) == 0);
  struct stat own{};
  if (::fstat(file, &own) != 0)
    return false;
  const mode_t wanted =
      own.st_gid == status.st_gid ? status.st_mode & kPermissions : forOthers(status.st_mode);
  // Some file systems have one set of permissions for all files, and refuse to be given any.
  return (own.st_mode & kPermissions) == wanted || ::fchmod(file, wanted) == 0;
}

void touch(const std::string &path) { ::utimensat(AT_FDCWD, path.c_str(), nullptr, 0); }

} // namespace voxc::platform
