// How a kernel meets the outside, as data: for programs that make pipelines of it themselves.
#pragma once

#include "voxc/Trace/Kernel.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace voxc {

/// A member of a record or of the push constants.
struct KernelField {
  std::string_view name;
  std::string_view type; ///< "uint32", "int32[3]", "float32[3]" or "uint64".
  std::uint32_t offset = 0;
};

/// A storage buffer: fields that stand there once, and behind them records, one after another.
struct KernelBinding {
  std::uint32_t binding = 0;
  std::string_view name;   ///< "rays", "hits", "words" or "deferred".
  std::string_view access; ///< "read", or "read write".
  std::vector<KernelField> header;
  std::uint32_t headerBytes = 0;
  std::vector<KernelField> record;
  std::uint32_t recordBytes = 0;
};

/// A specialization constant.
struct KernelConstant {
  std::uint32_t id = 0;
  std::string_view name;
  std::string_view type;         ///< "bool" or "float32".
  std::string_view defaultValue; ///< What it is if nobody says.
};

/// A compute shader's interface; what each part means is documented at `Kernel`.
struct KernelInterface {
  std::string_view entryPoint = "main";
  std::uint32_t workgroupSize = kWorkgroupSize; ///< Invocations, along x; an invocation a ray.
  std::uint32_t descriptorSet = 0;
  std::vector<KernelBinding> bindings; ///< In the order of their numbers, from 0.
  std::vector<KernelField> pushConstants;
  std::uint32_t pushConstantBytes = 0;
  std::vector<KernelConstant> constants;
  /// What the module needs of a device, by the names that Vulkan's structures of features and properties
  /// have: "shaderInt64", "bufferDeviceAddress".
  std::vector<std::string_view> features;
};

/// The interface of a kernel. Error (`Input`): its module is broken, or needs what voxc knows nothing of.
Expected<KernelInterface> interfaceOf(const Kernel &kernel);

} // namespace voxc
