// The scratch file by Linux.
#include "ScratchFile.h"

#include "UnnamedFile.h"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace voxc::platform {
namespace {

/// Where it must have a name, not for long.
int openScratch(const std::string &folder) {
  std::string path = folder + "/voxc-scratch";
  const int file = openUnnamed(path, Access::Owner);
  if (file >= 0 || !hasNoUnnamed(errno))
    return file;
  const int named = openNew(path, Access::Owner);
  if (named >= 0)
    ::unlink(path.c_str());
  return named;
}

} // namespace

std::string scratchFolder() {
  const char *const temporary = std::getenv("TMPDIR");
  return temporary && *temporary ? temporary : "/var/tmp";
}

ScratchFile::~ScratchFile() {
  if (file_ >= 0)
    ::close(file_);
}

int ScratchFile::extend(std::byte *at, std::uint64_t bytes) {
  if (file_ < 0)
    file_ = openScratch(folder_);
  if (file_ < 0)
    return errno;
  const auto offset = static_cast<off_t>(end_);
  // Room is taken now: a full disk found out later, by a write to the mapping, would end the process.
  if (const int why = ::posix_fallocate(file_, offset, static_cast<off_t>(bytes)); why != 0)
    return why;
  if (::mmap(at, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_FIXED, file_, offset) == MAP_FAILED)
    return errno;
  // Reading ahead would make large pages in the system's cache, which are dear to dirty a little at a time.
  ::madvise(at, bytes, MADV_RANDOM);
  end_ += bytes;
  return 0;
}

void ScratchFile::giveBack(std::uint64_t offset, std::uint64_t bytes) {
  // Where the system cannot punch holes the room is given back at the end.
  ::fallocate(file_, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, static_cast<off_t>(offset),
              static_cast<off_t>(bytes));
}

} // namespace voxc::platform
