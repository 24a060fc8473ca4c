// Vulkan's results as errors.
#pragma once

#include "Vulkan.h"

#include "voxc/Support/Error.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace voxc {

/// An `Environment` error: "the device could not ACTION: out of device memory".
Error vulkanError(std::string_view action, VkResult result);

/// A number of bytes for people: "1.50 GiB", "12 bytes".
std::string bytesText(std::uint64_t bytes);

} // namespace voxc
