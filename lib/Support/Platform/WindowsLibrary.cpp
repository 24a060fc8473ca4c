// Libraries by Windows.
#include "Library.h"

#include "WindowsApi.h"
#include "WindowsText.h"

namespace voxc::platform {

const char *const kVulkanLoader = "vulkan-1.dll";

void *openLibrary(const char *name) { return ::LoadLibraryW(wide(name).c_str()); }

void *findFunction(void *library, const char *name) {
  return reinterpret_cast<void *>(::GetProcAddress(static_cast<HMODULE>(library), name));
}

} // namespace voxc::platform
