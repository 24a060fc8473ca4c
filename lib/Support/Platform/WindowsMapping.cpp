// Mapped files by Windows.
#include "Mapping.h"

#include "WindowsError.h"
#include "WindowsHandle.h"

namespace voxc::platform {

const std::byte *mapFile(int file, std::size_t size) {
  const HANDLE mapping = ::CreateFileMappingW(handleOf(file), nullptr, PAGE_WRITECOPY, 0, 0, nullptr);
  // A view for reading alone could not be written over later. This one counts towards what the paging file
  // can hold.
  void *const address = mapping ? ::MapViewOfFile(mapping, FILE_MAP_COPY, 0, 0, size) : nullptr;
  DWORD before = 0;
  if (!address || !::VirtualProtect(address, size, PAGE_READONLY, &before))
    failed();
  if (mapping)
    ::CloseHandle(mapping); // The view keeps it.
  return static_cast<const std::byte *>(address);
}

void unmapFile(std::span<const std::byte> mapped) { ::UnmapViewOfFile(mapped.data()); }

void letGo(std::span<const std::byte> mapped) {
  // Pages that are not locked leave the working set, and what was written to them is not lost.
  ::VirtualUnlock(const_cast<std::byte *>(mapped.data()), mapped.size());
}

bool makeWritable(std::span<const std::byte> bytes) {
  void *const at = const_cast<std::byte *>(bytes.data());
  DWORD before = 0;
  // Pages of a view of a file are copied; other memory has none to copy from.
  return ::VirtualProtect(at, bytes.size(), PAGE_WRITECOPY, &before) ||
         succeeded(::VirtualProtect(at, bytes.size(), PAGE_READWRITE, &before));
}

} // namespace voxc::platform
