// Which memory a buffer goes into.
#pragma once

#include "Vulkan.h"

#include <cstdint>
#include <vector>

namespace voxc {

/// What a buffer's memory is best for.
enum class BufferPlace {
  Device,   ///< The kernels; the host sees it only where that costs nothing.
  Upload,   ///< Written by the host, read once by the device.
  Download, ///< Written by the device, read by the host.
};

/// The memory types that a buffer may use (bits of `allowed`), from the best for `placement` on.
std::vector<std::uint32_t> memoryTypesFor(const VkPhysicalDeviceMemoryProperties &memory,
                                          std::uint32_t allowed, BufferPlace placement);

/// True if the host can map memory with these properties and needs no flushes.
bool isMappable(VkMemoryPropertyFlags properties);

} // namespace voxc
