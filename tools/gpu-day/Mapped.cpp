// Files as arrays.
#include "Mapped.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace voxc::gpu {

Expected<MappedBytes> MappedBytes::open(const std::string &path) {
  const auto unreadable = [&] { return Error::input("'" + path + "' cannot be read: " + strerror(errno)); };
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0)
    return unreadable();
  struct stat status{};
  void *mapped = nullptr;
  const bool isKnown = ::fstat(file, &status) == 0;
  if (isKnown && status.st_size > 0)
    mapped = ::mmap(nullptr, static_cast<std::size_t>(status.st_size), PROT_READ, MAP_SHARED, file, 0);
  ::close(file);
  if (!isKnown || mapped == MAP_FAILED)
    return unreadable();
  return MappedBytes({static_cast<const std::byte *>(mapped), static_cast<std::size_t>(status.st_size)});
}

MappedBytes::~MappedBytes() {
  if (!bytes_.empty())
    ::munmap(const_cast<std::byte *>(bytes_.data()), bytes_.size());
}

} // namespace voxc::gpu
