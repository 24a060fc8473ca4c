// What kernels may ask of a device beyond plain Vulkan 1.2.
#include "Capabilities.h"

#include "Trace/Kernel/Spirv.h"

#include <algorithm>

namespace voxc {
namespace {

/// A capability of SPIR-V that follows from a core feature of Vulkan.
struct CoreFeature {
  std::uint32_t capability;
  std::string_view name;
  std::string_view member; ///< Its name in VkPhysicalDeviceFeatures.
  VkBool32 VkPhysicalDeviceFeatures::*feature;
};

constexpr CoreFeature kCoreFeatures[] = {
    {10, "64-bit floats", "shaderFloat64", &VkPhysicalDeviceFeatures::shaderFloat64},
    {11, "64-bit integers", "shaderInt64", &VkPhysicalDeviceFeatures::shaderInt64},
    {22, "16-bit integers", "shaderInt16", &VkPhysicalDeviceFeatures::shaderInt16},
};

constexpr std::uint32_t kShader = 1;
constexpr std::uint32_t kSampledBuffer = 46;
constexpr std::uint32_t kPhysicalStorageBufferAddresses = 5347;
constexpr std::uint32_t kRoundingModeRte = 4467;

Error missing(const PhysicalDevice &device, std::string_view what) {
  return Error::environment("this kernel needs " + std::string(what) + ", which " + device.info.name +
                            " lacks, or was opened without");
}

Expected<void> checkCapability(const PhysicalDevice &device, std::uint32_t capability) {
  if (isEverywhere(capability))
    return {};
  if (capability == kPhysicalStorageBufferAddresses && device.info.deviceAddresses)
    return {};
  if (capability == kPhysicalStorageBufferAddresses)
    return missing(device, "device addresses");
  if (capability == kRoundingModeRte)
    return device.roundsToNearest ? Expected<void>() : missing(device, "float32 that is rounded to nearest");
  const auto *row = std::ranges::find(kCoreFeatures, capability, &CoreFeature::capability);
  if (row == std::end(kCoreFeatures))
    return Error::environment("this kernel needs SPIR-V's capability " + std::to_string(capability) +
                              ", which voxc enables on no device");
  if (!(device.features.*row->feature))
    return missing(device, row->name);
  return {};
}

Expected<void> checkCapabilities(const PhysicalDevice &device, std::span<const std::uint32_t> spirv) {
  Expected<void> outcome;
  auto check = [&](const spirv::Instruction &instruction) {
    if (outcome && instruction.opcode == spirv::kOpCapability && !instruction.operands.empty())
      outcome = checkCapability(device, instruction.operands[0]);
  };
  VOXC_TRY(spirv::forEachInstruction(spirv, check));
  return outcome;
}

} // namespace

bool isEverywhere(std::uint32_t capability) { return capability == kShader || capability == kSampledBuffer; }

std::string_view featureOf(std::uint32_t capability) {
  if (capability == kPhysicalStorageBufferAddresses)
    return "bufferDeviceAddress";
  if (capability == kRoundingModeRte)
    return "shaderRoundingModeRTEFloat32";
  const auto *row = std::ranges::find(kCoreFeatures, capability, &CoreFeature::capability);
  return row == std::end(kCoreFeatures) ? std::string_view{} : row->member;
}

VkPhysicalDeviceFeatures kernelFeatures(const VkPhysicalDeviceFeatures &available) {
  VkPhysicalDeviceFeatures features{};
  for (const CoreFeature &row : kCoreFeatures)
    features.*row.feature = available.*row.feature;
  return features;
}

Expected<void> checkKernel(const PhysicalDevice &device, const Kernel &kernel) {
  if (kernel.loops == Loops::Whole && device.info.loops == Loops::Cut)
    return Error::input("this kernel is for devices that run every loop to its end, which " +
                        device.info.name + " does not: compile one with loops=cut");
  if (kernel.arithmetic == Arithmetic::Ieee && device.info.arithmetic != Arithmetic::Ieee)
    return Error::input(
        "this kernel is for devices whose arithmetic is that of IEEE 754, which is not known of " +
        device.info.name + ": compile one with arithmetic=any");
  return checkCapabilities(device, kernel.spirv);
}

} // namespace voxc
