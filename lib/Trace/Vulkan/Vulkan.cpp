// Vulkan's functions, looked up in the loader's library, or in a host's loader.
#include "Vulkan.h"

#include "Support/Platform/Library.h"

namespace voxc {
namespace {

/// Looks up every function, by its whole name; false if one is missing.
template <typename LookUp> bool fill(VulkanFunctions &functions, LookUp lookUp) {
  bool complete = true;
#define VOXC_LOOK_UP(name)                                                                                   \
  functions.name = reinterpret_cast<PFN_vk##name>(lookUp("vk" #name));                                       \
  complete = complete && functions.name != nullptr;
  VOXC_VULKAN_FUNCTIONS(VOXC_LOOK_UP)
#undef VOXC_LOOK_UP
  return complete;
}

std::optional<VulkanLoader> openLoader() {
  void *const library = platform::openLibrary(platform::kVulkanLoader);
  if (!library)
    return std::nullopt;
  const auto lookUp = [library](const char *name) { return platform::findFunction(library, name); };
  VulkanLoader loader;
  loader.CreateInstance = reinterpret_cast<PFN_vkCreateInstance>(lookUp("vkCreateInstance"));
  if (!fill(loader.functions, lookUp) || loader.CreateInstance == nullptr)
    return std::nullopt;
  return loader;
}

} // namespace

const VulkanLoader *loadVulkan() {
  static const std::optional<VulkanLoader> loader = openLoader();
  return loader ? &*loader : nullptr;
}

std::optional<VulkanFunctions> functionsOf(VkInstance instance, PFN_vkGetInstanceProcAddr loader) {
  VulkanFunctions functions;
  if (!fill(functions, [&](const char *name) { return loader(instance, name); }))
    return std::nullopt;
  return functions;
}

} // namespace voxc
