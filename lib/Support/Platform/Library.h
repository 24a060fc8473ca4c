// Libraries that are looked for while a program runs.
#pragma once

namespace voxc::platform {

/// What Vulkan's loader is called.
extern const char *const kVulkanLoader;

/// Opens one for good: drivers do not expect to be unloaded before the process ends. Null if it is not there.
void *openLibrary(const char *name);
/// Null if the library has no such function.
void *findFunction(void *library, const char *name);

} // namespace voxc::platform
