// Files by POSIX.
#include "File.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace voxc::platform {
namespace {

PathKind kindOf(const struct stat &status) {
  return S_ISREG(status.st_mode)   ? PathKind::File
         : S_ISDIR(status.st_mode) ? PathKind::Folder
                                   : PathKind::Other;
}

} // namespace

PathKind kindOf(const std::string &path) {
  struct stat status{};
  return ::stat(path.c_str(), &status) == 0 ? kindOf(status) : PathKind::Nothing;
}

std::optional<FileStatus> statusOf(int file) {
  struct stat status{};
  if (::fstat(file, &status) != 0)
    return std::nullopt;
  return FileStatus{kindOf(status), static_cast<std::uint64_t>(status.st_size)};
}

int openToRead(const std::string &path) { return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK); }

int openToWrite(const std::string &path) { return ::open(path.c_str(), O_WRONLY | O_CLOEXEC); }

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

void touch(const std::string &path) { ::utimensat(AT_FDCWD, path.c_str(), nullptr, 0); }

} // namespace voxc::platform
