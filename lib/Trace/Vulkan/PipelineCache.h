// What a driver made of a kernel, kept for the next time.
#pragma once

#include "Handle.h"

#include "voxc/Support/CompileCache.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace voxc {

/// Whether bytes begin with the header of pipeline cache data (VkPipelineCacheHeaderVersionOne) of this
/// device and driver: drivers are asked to check it, and not all do. Data of nothing but a header is of no
/// use.
bool isPipelineData(std::string_view bytes, const VkPhysicalDeviceProperties &device);

/// Pipelines of one kernel, as the driver compiled them: found in a `CompileCache`, and put there. They are
/// addressed by the kernel, the device, its driver's version and the UUID that the driver gives to what it
/// keeps.
class PipelineCache {
public:
  /// For a kernel and what else its pipelines are made of, as bytes of any kind; the kernel must stay.
  /// Without a cache, or where the driver makes none, `get` is null; nothing here fails.
  PipelineCache(const Device::State &device, const CompileCache *cache, std::string_view kernel,
                std::string_view constants);

  VkPipelineCache get() const { return handle_.get(); }
  /// Keeps what the driver has made since, if there is anything new.
  void store() const;

private:
  std::string data() const;

  const Device::State &device_;
  const CompileCache *cache_;
  VkPhysicalDeviceProperties properties_{};
  std::string identity_; ///< Of device and driver.
  std::string_view kernel_;
  std::string constants_;
  std::string found_; ///< Empty: nothing that could be used.
  PipelineCacheHandle handle_;
};

} // namespace voxc
