// Vulkan's functions, looked up in the loader's library.
#include "Vulkan.h"

#include <dlfcn.h>

namespace voxc {

#define VOXC_DEFINE(name) PFN_##name name = nullptr;
VOXC_VULKAN_FUNCTIONS(VOXC_DEFINE)
#undef VOXC_DEFINE

namespace {

template <typename Function> bool lookUp(void *library, const char *name, Function &function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  return function != nullptr;
}

bool lookUpAll() {
  // Never closed: drivers do not expect to be unloaded before the process ends.
  void *library = dlopen("libvulkan.so.1", RTLD_NOW | RTLD_LOCAL);
  if (!library)
    return false;
  bool complete = true;
#define VOXC_LOOK_UP(name) complete = lookUp(library, #name, name) && complete;
  VOXC_VULKAN_FUNCTIONS(VOXC_LOOK_UP)
#undef VOXC_LOOK_UP
  return complete;
}

} // namespace

bool loadVulkan() {
  static const bool loaded = lookUpAll();
  return loaded;
}

} // namespace voxc
