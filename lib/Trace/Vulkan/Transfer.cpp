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

Expected<std::uint64_t> Transfer::upload(std::span<const std::uint32_t> words,
                                         std::span<const WordRange> ranges, Buffer &buffer) {
  std::vector<VkBufferCopy> regions;
  std::uint64_t staged = 0, copied = 0;
  auto stage = buffer.writable() ? Expected<Buffer *>(&buffer) : staging(uploadStaging_, BufferPlace::Upload);
  if (!stage)
    return stage.error();
  const auto flush = [&]() -> Expected<void> {
    const std::span<const VkBufferCopy> waiting = regions;
    auto done = waiting.empty() ? Expected<void>() : copy(**stage, buffer, waiting);
    regions.clear();
    staged = 0;
    return done;
  };
  for (const WordRange &range : ranges) {
    const auto bytes = std::as_bytes(words.subspan(range.first, range.end - range.first));
    const std::uint64_t at = range.first * sizeof(std::uint32_t);
    copied += bytes.size();
    if (staged + bytes.size() > kStagingBytes)
      if (auto flushed = flush(); !flushed)
        return flushed.error();
    if (buffer.writable() || bytes.size() > kStagingBytes) {
      if (auto uploaded = upload(bytes, buffer, at); !uploaded)
        return uploaded.error();
      continue;
    }
    std::memcpy((*stage)->writable() + staged, bytes.data(), bytes.size());
    regions.push_back({staged, at, bytes.size()});
    staged += bytes.size();
  }
  if (auto flushed = flush(); !flushed)
    return flushed.error();
  return copied;
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

Expected<void> Transfer::copy(const Buffer &from, const Buffer &to, std::span<const VkBufferCopy> regions) {
  auto commands = commands_.begin();
  if (!commands)
    return commands.error();
  device_->vk.CmdCopyBuffer(*commands, from.get(), to.get(), static_cast<std::uint32_t>(regions.size()),
                            regions.data());
  recordBarrier(*device_, *commands);
  if (auto submitted = commands_.submit(); !submitted)
    return submitted;
  return commands_.wait();
}

} // namespace voxc
