// Where memory lies that a bound does not leave in memory: one file that has no name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace voxc::platform {

/// The folder for large temporary files.
std::string scratchFolder();

/// Made when it is first extended, and gone whatever ends the process. Where the system itself writes to its
/// own file what does not fit into memory, that is it.
class ScratchFile {
public:
  explicit ScratchFile(std::string folder) : folder_(std::move(folder)) {}
  ~ScratchFile();
  ScratchFile(const ScratchFile &) = delete;
  ScratchFile &operator=(const ScratchFile &) = delete;

  const std::string &folder() const { return folder_; }
  /// Maps further zeroed bytes of it to reserved addresses, whole pages. Returns 0, or an `errno`.
  int extend(std::byte *at, std::uint64_t bytes);
  /// Where these begin.
  std::uint64_t end() const { return end_; }
  /// Gives the room of such bytes back, as far as the system can.
  void giveBack(std::uint64_t offset, std::uint64_t bytes);

private:
  std::string folder_;
  int file_ = -1;
  std::uint64_t end_ = 0;
};

} // namespace voxc::platform
