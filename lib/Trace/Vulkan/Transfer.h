// Copies between the host and device buffers: straight where the host sees them, through a staging buffer
// else.
#pragma once

#include "Buffer.h"
#include "Commands.h"

#include "voxc/Volume/WordRange.h"

#include <optional>
#include <span>

namespace voxc {

class Transfer {
public:
  static Expected<Transfer> create(Device::State &device);

  /// Copies `bytes` into `buffer`, which must hold them, from byte `at` on. Returns when they are there.
  Expected<void> upload(std::span<const std::byte> bytes, Buffer &buffer, std::uint64_t at = 0);
  /// Copies those runs of words into a buffer that has all of them, at once. Returns the bytes.
  Expected<std::uint64_t> upload(std::span<const std::uint32_t> words, std::span<const WordRange> ranges,
                                 Buffer &buffer);
  /// Copies the start of `buffer` into `bytes`.
  Expected<void> download(const Buffer &buffer, std::span<std::byte> bytes);

  /// Copies from one buffer into another, on the device. Returns when it is done.
  Expected<void> copy(const Buffer &from, const Buffer &to, const VkBufferCopy &region) {
    return copy(from, to, std::span(&region, 1));
  }
  Expected<void> copy(const Buffer &from, const Buffer &to, std::span<const VkBufferCopy> regions);

private:
  Transfer(Device::State &device, Commands commands) : device_(&device), commands_(std::move(commands)) {}
  Expected<Buffer *> staging(std::optional<Buffer> &buffer, BufferPlace placement);

  Device::State *device_;
  Commands commands_;
  std::optional<Buffer> uploadStaging_;   ///< Made when first needed.
  std::optional<Buffer> downloadStaging_; ///< Made when first needed.
};

} // namespace voxc
