// Pages by Linux.
#include "Pages.h"

#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

namespace voxc::platform {
namespace {

/// From here up large pages are asked for: tables are read at random, and those spare much of the way to
/// each.
constexpr std::uint64_t kLargePages = std::uint64_t{2} << 20;

std::byte *orNull(void *address) {
  return address == MAP_FAILED ? nullptr : static_cast<std::byte *>(address);
}

bool mapAt(std::byte *at, std::uint64_t bytes, int protection, int file, std::uint64_t offset) {
  return ::mmap(at, bytes, protection, MAP_SHARED | MAP_FIXED, file, static_cast<off_t>(offset)) !=
         MAP_FAILED;
}

} // namespace

std::uint64_t pageBytes() {
  static const auto bytes = static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  return bytes;
}

std::byte *reserve(std::uint64_t bytes) {
  return orNull(::mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0));
}

void release(std::byte *at, std::uint64_t bytes) { ::munmap(at, bytes); }

std::optional<std::uint64_t> mostAddresses() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return std::nullopt;
  return limit.rlim_cur;
}

bool addMemory(std::byte *at, std::uint64_t bytes) {
  if (::mprotect(at, bytes, PROT_READ | PROT_WRITE) != 0)
    return false;
  if (bytes >= kLargePages)
    ::madvise(at, bytes, MADV_HUGEPAGE);
  return true;
}

bool replaceByFile(std::byte *at, std::uint64_t bytes, int file, std::uint64_t offset) {
  return mapAt(at, bytes, PROT_READ, file, offset);
}

int openShared(std::uint64_t /*most*/) { return ::memfd_create("voxc", MFD_CLOEXEC); }

void closeShared(int shared) { ::close(shared); }

std::byte *reserveShared(int /*shared*/, std::uint64_t most) { return reserve(most); }

bool addShared(std::byte *begin, std::uint64_t bytes, int shared, std::uint64_t offset) {
  if (::ftruncate(shared, static_cast<off_t>(offset + bytes)) != 0 ||
      !mapAt(begin + offset, bytes, PROT_READ | PROT_WRITE, shared, offset))
    return false;
  ::madvise(begin + offset, bytes, MADV_HUGEPAGE);
  return true;
}

std::byte *viewShared(int shared, std::uint64_t bytes) {
  return orNull(::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE, shared, 0));
}

} // namespace voxc::platform
