// Vulkan's results as errors.
#include "VulkanError.h"

#include <array>
#include <cstdio>

namespace voxc {
namespace {

struct ResultText {
  VkResult result;
  std::string_view text;
};

constexpr ResultText kResultTexts[] = {
    {VK_ERROR_OUT_OF_HOST_MEMORY, "out of host memory"},
    {VK_ERROR_OUT_OF_DEVICE_MEMORY, "out of device memory"},
    {VK_ERROR_INITIALIZATION_FAILED, "its driver failed to start"},
    {VK_ERROR_DEVICE_LOST, "the device was lost"},
    {VK_ERROR_MEMORY_MAP_FAILED, "its memory could not be mapped"},
    {VK_ERROR_FEATURE_NOT_PRESENT, "it lacks a feature"},
    {VK_ERROR_EXTENSION_NOT_PRESENT, "it lacks an extension"},
    {VK_ERROR_INCOMPATIBLE_DRIVER, "its driver is too old"},
    {VK_ERROR_TOO_MANY_OBJECTS, "too many objects"},
    {VK_ERROR_INVALID_SHADER_NV, "it refused the kernel"},
};

std::string resultText(VkResult result) {
  for (const ResultText &row : kResultTexts)
    if (row.result == result)
      return std::string(row.text);
  return "Vulkan's result " + std::to_string(static_cast<int>(result));
}

} // namespace

Error vulkanError(std::string_view action, VkResult result) {
  return Error::environment("the device could not " + std::string(action) + ": " + resultText(result));
}

std::string bytesText(std::uint64_t bytes) {
  constexpr std::string_view kUnits[] = {"KiB", "MiB", "GiB", "TiB"};
  if (bytes < 1024)
    return std::to_string(bytes) + " bytes";
  double amount = static_cast<double>(bytes) / 1024;
  std::size_t unit = 0;
  for (; amount >= 1024 && unit + 1 < std::size(kUnits); ++unit)
    amount /= 1024;
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.2f ", amount);
  return text.data() + std::string(kUnits[unit]);
}

} // namespace voxc
