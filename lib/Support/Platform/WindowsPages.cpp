// Pages by Windows.
#include "Pages.h"

#include "WindowsApi.h"
#include "WindowsError.h"

namespace voxc::platform {
namespace {

/// Handles have 32 bits that count, in every process.
int numberOf(HANDLE handle) {
  return handle ? static_cast<int>(reinterpret_cast<std::intptr_t>(handle)) : -1;
}
HANDLE handleOf(int number) { return reinterpret_cast<HANDLE>(static_cast<std::intptr_t>(number)); }

std::byte *orFailed(void *address) {
  return address || failed() ? static_cast<std::byte *>(address) : nullptr;
}

} // namespace

std::uint64_t pageBytes() {
  static const std::uint64_t bytes = [] {
    SYSTEM_INFO facts{};
    ::GetSystemInfo(&facts);
    return facts.dwPageSize;
  }();
  return bytes;
}

std::byte *reserve(std::uint64_t bytes) {
  return orFailed(::VirtualAlloc(nullptr, bytes, MEM_RESERVE, PAGE_NOACCESS));
}

void release(std::byte *at, std::uint64_t /*bytes*/) {
  if (!::VirtualFree(at, 0, MEM_RELEASE))
    ::UnmapViewOfFile(at); // Of shared memory.
}

std::optional<std::uint64_t> mostAddresses() { return std::nullopt; }

bool addMemory(std::byte *at, std::uint64_t bytes) {
  return succeeded(::VirtualAlloc(at, bytes, MEM_COMMIT, PAGE_READWRITE) != nullptr);
}

/// No view of a file can be put between other pages: they become read only, and Windows may write them to its
/// paging file.
bool replaceByFile(std::byte *at, std::uint64_t bytes, int /*file*/, std::uint64_t /*offset*/) {
  DWORD before = 0;
  return succeeded(::VirtualProtect(at, bytes, PAGE_READONLY, &before));
}

int openShared(std::uint64_t most) {
  const HANDLE section =
      ::CreateFileMappingW(INVALID_HANDLE_VALUE, nullptr, PAGE_READWRITE | SEC_RESERVE,
                           static_cast<DWORD>(most >> 32), static_cast<DWORD>(most), nullptr);
  if (!section)
    failed();
  return numberOf(section);
}

void closeShared(int shared) { ::CloseHandle(handleOf(shared)); }

std::byte *reserveShared(int shared, std::uint64_t most) {
  return orFailed(::MapViewOfFile(handleOf(shared), FILE_MAP_WRITE, 0, 0, most));
}

bool addShared(std::byte *begin, std::uint64_t bytes, int /*shared*/, std::uint64_t offset) {
  return addMemory(begin + offset, bytes);
}

std::byte *viewShared(int shared, std::uint64_t bytes) {
  return orFailed(::MapViewOfFile(handleOf(shared), FILE_MAP_COPY, 0, 0, bytes));
}

} // namespace voxc::platform
