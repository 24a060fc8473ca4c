// Mapped files by POSIX.
#include "Mapping.h"

#include "Pages.h"

#include <cstdint>
#include <sys/mman.h>

namespace voxc::platform {

const std::byte *mapFile(int file, std::size_t size) {
  void *const address = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
  return address == MAP_FAILED ? nullptr : static_cast<const std::byte *>(address);
}

void unmapFile(std::span<const std::byte> mapped) {
  ::munmap(const_cast<std::byte *>(mapped.data()), mapped.size());
}

void letGo(std::span<const std::byte> mapped) {
  // Shared pages stay in the system's cache, and what was written to them is not lost.
  ::madvise(const_cast<std::byte *>(mapped.data()), mapped.size(), MADV_DONTNEED);
}

bool makeWritable(std::span<const std::byte> bytes) {
  const std::size_t before = reinterpret_cast<std::uintptr_t>(bytes.data()) % pageBytes(); // In its page.
  std::byte *const begin = const_cast<std::byte *>(bytes.data()) - before;
  // Mappings are private: what is written to is a copy.
  return ::mprotect(begin, before + bytes.size(), PROT_READ | PROT_WRITE) == 0;
}

} // namespace voxc::platform
