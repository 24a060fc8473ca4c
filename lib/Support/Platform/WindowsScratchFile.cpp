// Windows writes what does not fit into memory to its paging file: no other is needed.
#include "ScratchFile.h"

#include "File.h"
#include "Pages.h"
#include "Path.h"

#include <cerrno>

namespace voxc::platform {

std::string scratchFolder() {
  std::error_code failure;
  return utf8From(std::filesystem::temp_directory_path(failure));
}

ScratchFile::~ScratchFile() = default;

int ScratchFile::extend(std::byte *at, std::uint64_t bytes) {
  if (kindOf(folder_) != PathKind::Folder)
    return ENOENT; // A name that is wrong is told on every system.
  if (!addMemory(at, bytes))
    return errno;
  end_ += bytes;
  return 0;
}

/// The addresses are given back at the same time, and so is all that lies there.
void ScratchFile::giveBack(std::uint64_t /*offset*/, std::uint64_t /*bytes*/) {}

} // namespace voxc::platform
