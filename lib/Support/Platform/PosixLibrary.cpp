// Libraries by POSIX.
#include "Library.h"

#include <dlfcn.h>

namespace voxc::platform {

const char *const kVulkanLoader = "libvulkan.so.1";

void *openLibrary(const char *name) { return ::dlopen(name, RTLD_NOW | RTLD_LOCAL); }

void *findFunction(void *library, const char *name) { return ::dlsym(library, name); }

} // namespace voxc::platform
