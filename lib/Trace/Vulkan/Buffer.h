// Device buffers with the memory behind them.
#pragma once

#include "DeviceState.h"
#include "Handle.h"
#include "MemoryTypes.h"

#include <cstddef>
#include <cstdint>

namespace voxc {

/// What a buffer is for.
struct BufferRequest {
  std::string_view what; ///< For errors: "the rays".
  std::uint64_t bytes = 0;
  BufferPlace placement = BufferPlace::Device;
  bool addressed = false; ///< Kernels reach it by its address.
  bool texels = false;    ///< Kernels read its words as texels.
  bool starts = false;    ///< Dispatches are started with numbers in it.
};

/// A storage and transfer buffer.
class Buffer {
public:
  /// Errors: `Environment`, naming the sizes, if the device cannot hold it.
  static Expected<Buffer> create(Device::State &device, const BufferRequest &request);

  VkBuffer get() const { return buffer_.get(); }
  std::uint64_t bytes() const { return bytes_; }
  /// Where the host can write it; null where it cannot.
  std::byte *writable() const { return mapped_; }
  /// Where the host can read it at full speed; null where it cannot.
  const std::byte *readable() const { return cached_ ? mapped_ : nullptr; }
  VkDeviceAddress address(const Device::State &device) const;

private:
  Buffer(BufferHandle buffer, std::uint64_t bytes) : buffer_(std::move(buffer)), bytes_(bytes) {}
  Expected<void> bind(Device::State &device, const BufferRequest &request);
  VkResult allocate(Device::State &device, const BufferRequest &request);
  VkResult map(Device::State &device, std::uint32_t type);

  MemoryHandle memory_; ///< Outlives the buffer: members are destroyed from the last to the first.
  BufferHandle buffer_;
  std::uint64_t bytes_ = 0;
  std::byte *mapped_ = nullptr;
  bool cached_ = false; ///< Its mapping is read through the host's caches.
};

} // namespace voxc
