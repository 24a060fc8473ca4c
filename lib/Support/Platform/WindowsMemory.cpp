// Memory as Windows tells of it.
#include "Memory.h"

#include "WindowsApi.h"

#include <psapi.h>

namespace voxc::platform {

std::uint64_t physicalMemory() {
  MEMORYSTATUSEX status{};
  status.dwLength = sizeof status;
  return ::GlobalMemoryStatusEx(&status) ? status.ullTotalPhys : 0;
}

ResidentSize::ResidentSize() = default;

ResidentSize::~ResidentSize() = default;

std::uint64_t ResidentSize::now() const {
  PROCESS_MEMORY_COUNTERS counters{};
  return ::K32GetProcessMemoryInfo(::GetCurrentProcess(), &counters, sizeof counters)
             ? counters.WorkingSetSize
             : 0;
}

} // namespace voxc::platform
