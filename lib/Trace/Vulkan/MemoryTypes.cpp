// Which memory a buffer goes into.
#include "MemoryTypes.h"

#include <algorithm>

namespace voxc {
namespace {

constexpr VkMemoryPropertyFlags kLocal = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
constexpr VkMemoryPropertyFlags kHost =
    VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
constexpr VkMemoryPropertyFlags kCached = VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
/// Types with any other property (protected, lazily allocated, uncached by the device) serve other purposes.
constexpr VkMemoryPropertyFlags kOrdinary = kLocal | kHost | kCached;

struct Wish {
  BufferPlace placement;
  VkMemoryPropertyFlags properties;
};

/// For each placement, the properties to look for, the best first.
constexpr Wish kWishes[] = {
    {BufferPlace::Device, kLocal},
    {BufferPlace::Upload, kHost},
    {BufferPlace::Download, kHost | kCached},
    {BufferPlace::Download, kHost},
};

} // namespace

std::vector<std::uint32_t> memoryTypesFor(const VkPhysicalDeviceMemoryProperties &memory,
                                          std::uint32_t allowed, BufferPlace placement) {
  std::vector<std::uint32_t> types;
  for (const Wish &wish : kWishes) {
    for (std::uint32_t type = 0; type < memory.memoryTypeCount; ++type) {
      VkMemoryPropertyFlags properties = memory.memoryTypes[type].propertyFlags;
      bool fits = (properties & wish.properties) == wish.properties && !(properties & ~kOrdinary);
      if (wish.placement == placement && fits && (allowed >> type & 1) && !std::ranges::count(types, type))
        types.push_back(type);
    }
  }
  return types;
}

bool isMappable(VkMemoryPropertyFlags properties) { return (properties & kHost) == kHost; }

} // namespace voxc
