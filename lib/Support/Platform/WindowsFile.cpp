// Files by Windows.
#include "File.h"

#include "Path.h"
#include "WindowsError.h"
#include "WindowsHandle.h"
#include "WindowsText.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <io.h>

namespace voxc::platform {
namespace {

constexpr DWORD kShared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
/// For what another process, such as one that looks for viruses, has open for a moment.
constexpr int kAttempts = 200;
constexpr DWORD kPauseMilliseconds = 5;

LARGE_INTEGER large(std::uint64_t number) {
  LARGE_INTEGER result;
  result.QuadPart = static_cast<LONGLONG>(number);
  return result;
}

PathKind kindOf(HANDLE handle) {
  BY_HANDLE_FILE_INFORMATION facts{};
  if (::GetFileType(handle) != FILE_TYPE_DISK || !::GetFileInformationByHandle(handle, &facts))
    return PathKind::Other;
  return (facts.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0 ? PathKind::Folder : PathKind::File;
}

/// Opens folders too.
HANDLE openAnything(const std::string &path, DWORD access) {
  return ::CreateFileW(wide(path).c_str(), access, kShared, nullptr, OPEN_EXISTING,
                       FILE_FLAG_BACKUP_SEMANTICS, nullptr);
}

int minusOne() {
  failed();
  return -1;
}

int numberOf(HANDLE handle, int flags) {
  const int file =
      ::_open_osfhandle(reinterpret_cast<std::intptr_t>(handle), flags | _O_BINARY | _O_NOINHERIT);
  if (file < 0)
    ::CloseHandle(handle);
  return file;
}

} // namespace

HANDLE handleOf(int file) { return reinterpret_cast<HANDLE>(::_get_osfhandle(file)); }

int openFile(const std::string &path, DWORD access, DWORD disposition) {
  const HANDLE handle = ::CreateFileW(wide(path).c_str(), access, kShared, nullptr, disposition,
                                      FILE_ATTRIBUTE_NORMAL, nullptr);
  return handle == INVALID_HANDLE_VALUE ? minusOne() : numberOf(handle, 0);
}

PathKind kindOf(const std::string &path) {
  const HANDLE handle = openAnything(path, FILE_READ_ATTRIBUTES);
  if (handle == INVALID_HANDLE_VALUE)
    return PathKind::Nothing;
  const PathKind kind = kindOf(handle);
  ::CloseHandle(handle);
  return kind;
}

/// Links are rare here; one is replaced.
std::optional<LinkEnd> followLinks(const std::string &path) {
  std::error_code failure;
  if (!std::filesystem::is_symlink(pathFrom(path), failure))
    return LinkEnd{path};
  const std::filesystem::path end = std::filesystem::weakly_canonical(pathFrom(path), failure);
  errno = ELOOP;
  return failure ? std::nullopt : std::optional(LinkEnd{utf8From(end)});
}

std::optional<FileStatus> statusOf(int file) {
  const HANDLE handle = handleOf(file);
  const PathKind kind = kindOf(handle);
  LARGE_INTEGER bytes{};
  if (kind == PathKind::File && !succeeded(::GetFileSizeEx(handle, &bytes)))
    return std::nullopt;
  return FileStatus{kind, static_cast<std::uint64_t>(bytes.QuadPart)};
}

int openToRead(const std::string &path) {
  const HANDLE handle = openAnything(path, GENERIC_READ);
  return handle == INVALID_HANDLE_VALUE ? minusOne() : numberOf(handle, _O_RDONLY);
}

int openToWrite(const std::string &path) { return openFile(path, GENERIC_WRITE, OPEN_EXISTING); }

void close(int file) { ::_close(file); }

std::FILE *streamTo(int file) { return ::_fdopen(file, "wb"); }

int fileOf(std::FILE *stream) { return ::_fileno(stream); }

bool writeAt(int file, std::span<const std::byte> bytes, std::uint64_t offset) {
  // A write at an offset moves the place of other writes along, unlike POSIX's.
  LARGE_INTEGER place{};
  if (!succeeded(::SetFilePointerEx(handleOf(file), {}, &place, FILE_CURRENT)))
    return false;
  while (!bytes.empty()) {
    constexpr std::size_t kMostAtOnce = std::size_t{1} << 30;
    OVERLAPPED at{};
    at.Offset = large(offset).LowPart;
    at.OffsetHigh = static_cast<DWORD>(large(offset).HighPart);
    DWORD written = 0;
    const auto count = static_cast<DWORD>(std::min(bytes.size(), kMostAtOnce));
    if (!succeeded(::WriteFile(handleOf(file), bytes.data(), count, &written, &at)))
      return false;
    bytes = bytes.subspan(written);
    offset += written;
  }
  return succeeded(::SetFilePointerEx(handleOf(file), place, nullptr, FILE_BEGIN));
}

bool extendTo(int file, std::uint64_t bytes) {
  const auto status = statusOf(file);
  if (!status || status->bytes >= bytes)
    return status.has_value();
  FILE_END_OF_FILE_INFO end{large(bytes)};
  return succeeded(::SetFileInformationByHandle(handleOf(file), FileEndOfFileInfo, &end, sizeof end));
}

bool writeThrough(int file) { return succeeded(::FlushFileBuffers(handleOf(file))); }

bool renameOver(const std::string &from, const std::string &to) {
  for (int attempt = 0;; ++attempt) {
    if (::MoveFileExW(wide(from).c_str(), wide(to).c_str(),
                      MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH))
      return true;
    failed();
    if (errno != EACCES || attempt == kAttempts)
      return false;
    ::Sleep(kPauseMilliseconds);
  }
}

bool removeFile(const std::string &path) { return succeeded(::DeleteFileW(wide(path).c_str())); }

/// Who may open a file is a matter of its folder.
bool takeAccessOf(const std::string & /*path*/, int /*file*/) { return true; }

void touch(const std::string &path) {
  const HANDLE handle = openAnything(path, FILE_WRITE_ATTRIBUTES);
  if (handle == INVALID_HANDLE_VALUE)
    return;
  FILETIME now{};
  ::GetSystemTimePreciseAsFileTime(&now);
  ::SetFileTime(handle, nullptr, &now, &now);
  ::CloseHandle(handle);
}

} // namespace voxc::platform
