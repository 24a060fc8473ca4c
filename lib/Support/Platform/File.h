// Open files and names of files. They are numbers as the C library has them on every system; what fails says
// why by `errno`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <span>
#include <string>

namespace voxc::platform {

enum class PathKind { Nothing, File, Folder, Other };

/// What stands at a path; `Nothing` too where that cannot be told.
PathKind kindOf(const std::string &path);

/// Where a name leads.
struct LinkEnd {
  std::string path; ///< Of what is there, or is to be made there: no link, but of one that `isOpen`.
  /// A link of the system to what a process has open, such as /dev/stdout, whatever name that has.
  bool isOpen = false;
};

/// Follows symbolic links of a last part, one after another; what is no link leads to itself. Nothing, with
/// `errno`, where they go around in a circle, or this process may not follow them.
std::optional<LinkEnd> followLinks(const std::string &path);

struct FileStatus {
  PathKind kind;
  std::uint64_t bytes;
};

/// Of an open file.
std::optional<FileStatus> statusOf(int file);

/// Opens what is there, and waits for nobody, such as the other end of a pipe; -1 if that fails.
int openToRead(const std::string &path);
/// The same for a pipe or a device, which is written to and stays what it is. What is written to a file that
/// is open comes behind what it has.
int openToWrite(const std::string &path);
void close(int file);

/// A stream that writes to an open file, and closes it; null if that fails.
std::FILE *streamTo(int file);
int fileOf(std::FILE *stream);

/// Writes all of them; false if the disk takes less.
bool writeAt(int file, std::span<const std::byte> bytes, std::uint64_t offset);
/// Makes a file longer by zeros, which take no room where the system has holes. One that is long enough
/// stays.
bool extendTo(int file, std::uint64_t bytes);
/// Sees what was written onto the disk.
bool writeThrough(int file);

/// At once: what has the name `to` is there until then.
bool renameOver(const std::string &from, const std::string &to);
bool removeFile(const std::string &path);
/// Gives an open file the permissions of the one at `path`, if it is there, and its owner and group where
/// this process may do that; another group has what all others have. False with `errno` if that fails.
bool takeAccessOf(const std::string &path, int file);
/// Has a file changed now.
void touch(const std::string &path);

} // namespace voxc::platform
