// Copies between the host and device buffers.
#include "Transfer.h"

#include <algorithm>
#include <cstring>

namespace voxc {
namespace {

constexpr std::size_t kStagingBytes = std::size_t{32} << 20;

} // namespace

Expected<Transfer> Transfer::create(Device::State &device) {
  auto commands = Commands::create(device);
  if (!commands)
    return commands.error();
  return Transfer(device, std::move(*commands));
}

Expected<void> Transfer::upload(std::span<const std::byte> bytes, Buffer &buffer, std::uint64_t at) {
  if (buffer.writable()) {
    std::memcpy(buffer.writable() + at, bytes.data(), bytes.size());
    return {};
  }
  auto stage = staging(uploadStaging_, BufferPlace::Upload);
  if (!stage)
    return stage.error();
  for (std::size_t offset = 0; offset < bytes.size(); offset += kStagingBytes) {
    std::size_t size = std::min(kStagingBytes, bytes.size() - offset);
    std::memcpy((*stage)->writable(), bytes.data() + offset, size);
    if (auto copied = copy(**stage, buffer, {0, at + offset, size}); !copied)
      return copied;
  }
  return {};
}

Expected<void> Transfer::download(const Buffer &buffer, std::span<std::byte> bytes) {
  if (buffer.readable()) {
    std::memcpy(bytes.data(), buffer.readable(), bytes.size());
    return {};
  }
  auto stage = staging(downloadStaging_, BufferPlace::Download);
  if (!stage)
    return stage.error();
  for (std::size_t offset = 0; offset < bytes.size(); offset += kStagingBytes) {
    std::size_t size = std::min(kStagingBytes, bytes.size() - offset);
    if (auto copied = copy(buffer, **stage, {offset, 0, size}); !copied)
      return copied;
    std::memcpy(bytes.data() + offset, (*stage)->writable(), size);
  }
  return {};
}

Expected<Buffer *> Transfer::staging(std::optional<Buffer> &buffer, BufferPlace placement) {
  if (!buffer) {
    auto created =
        Buffer::create(*device_, {.what = "staged copies", .bytes = kStagingBytes, .placement = placement});
    if (!created)
      return created.error();
    buffer.emplace(std::move(*created));
  }
  return &*buffer;
}

Expected<void> Transfer::copy(const Buffer &from, const Buffer &to, const VkBufferCopy &region) {
  auto commands = commands_.begin();
  if (!commands)
    return commands.error();
  device_->vk.CmdCopyBuffer(*commands, from.get(), to.get(), 1, &region);
  recordBarrier(*device_, *commands);
  if (auto submitted = commands_.submit(); !submitted)
    return submitted;
  return commands_.wait();
}

} // namespace voxc
