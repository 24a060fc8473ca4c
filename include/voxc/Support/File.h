// Whole files: mapped for reading, and written so that a name never holds half a file.
#pragma once

#include "voxc/Support/Error.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace voxc {

/// A regular file mapped into memory, read only; unmapped on destruction.
class MappedFile {
public:
  /// Errors: `Input` if `path` is missing, a directory or another thing that is not a file; `Environment` if
  /// it may not be read, or cannot be.
  static Expected<MappedFile> open(const std::string &path);
  ~MappedFile();
  MappedFile(MappedFile &&) noexcept;
  MappedFile &operator=(MappedFile &&) noexcept;

  std::span<const std::byte> bytes() const { return {data_, size_}; }
  /// Lets all of its pages go out of this process, as after reading it once; what is read again comes back.
  void letGo() const;

private:
  MappedFile() = default;
  const std::byte *data_ = nullptr;
  std::size_t size_ = 0;
};

/// Writes over bytes of a file that is mapped, or of other memory of this process: the file itself stays as
/// it is, and other mappings do. `at` and `bytes` have one length. Error: `Environment`.
Expected<void> writeOver(std::span<const std::byte> at, std::span<const std::byte> bytes);

/// A file without a name, which takes that of `path` on `commit` and else disappears, however the process
/// ends. Where a file system has no such files, it has a temporary name beside `path`, which a process that
/// is killed leaves behind. A symbolic link stays, and the file is made where it leads; one that replaces
/// another has its permissions.
class OutputFile {
public:
  /// Errors: `Environment` if nothing can be written there; `Input` if `path` is a directory.
  static Expected<OutputFile> create(const std::string &path);
  /// Whether a file that is created for `path` would be regular. Asks without opening what is there, as
  /// readers of a pipe take it for ended once a writer has closed it. Error (`Environment`): links that
  /// cannot be followed.
  static Expected<bool> isRegularAt(const std::string &path);
  ~OutputFile();
  OutputFile(OutputFile &&) noexcept;
  OutputFile &operator=(OutputFile &&) = delete;

  /// Appends bytes. Error: `Environment`, such as a full disk.
  Expected<void> write(const void *data, std::size_t size);
  /// Writes over bytes that were written before. Error: `Environment`.
  Expected<void> rewrite(std::uint64_t offset, const void *data, std::size_t size);
  /// The file itself, for anyone who writes in any order; `write` is not to be mixed with that.
  int descriptor() const;
  /// True if there is a file of its own, not a pipe, a device, or a file that is open as /dev/stdout is.
  bool isRegular() const { return replaces_; }
  /// Sees all of it onto the disk, then gives it the final name: whatever happens, `path` is what it was or
  /// is whole.
  Expected<void> commit();

private:
  OutputFile() = default;
  bool open();
  Error cannotWrite() const;

  std::string path_;      ///< As it was given, for messages.
  std::string target_;    ///< Where links of it lead.
  std::string temporary_; ///< "" while the file has no name.
  bool replaces_ = false; ///< What stands at the path, rather than to write into it.
  std::FILE *file_ = nullptr;
};

/// The text of a file. Errors as `MappedFile::open`.
Expected<std::string> readTextFile(const std::string &path);

/// Writes a whole file through `OutputFile`.
Expected<void> writeFile(const std::string &path, std::string_view bytes);

} // namespace voxc
