// Copies between the host and device buffers.
#include "Transfer.h"

#include <algorithm>
#include <cstring>

namespace voxc {
namespace {

constexpr std::size_t kStagingBytes = std::size_t{32} << 20;

} // namespace

Expected<Transfer> Transfer::create(Device::State &device) {
  auto commands = VOXC_TRY(Commands::create(device));
  return Transfer(device, std::move(commands));
}

Expected<void> Transfer::upload(std::span<const std::byte> bytes, Buffer &buffer, std::uint64_t at) {
  if (buffer.writable()) {
    std::memcpy(buffer.writable() + at, bytes.data(), bytes.size());
    return {};
  }
  auto stage = VOXC_TRY(staging(uploadStaging_, BufferPlace::Upload));
  for (std::size_t offset = 0; offset < bytes.size(); offset += kStagingBytes) {
    std::size_t size = std::min(kStagingBytes, bytes.size() - offset);
    std::memcpy(stage->writable(), bytes.data() + offset, size);
    VOXC_TRY(copy(*stage, buffer, {0, at + offset, size}));
  }
  return {};
}

Expected<std::uint64_t> Transfer::upload(std::span<const std::uint32_t> words,
                                         std::span<const WordRange> ranges, Buffer &buffer) {
  std::vector<VkBufferCopy> regions;
  std::uint64_t staged = 0, copied = 0;
  auto stage = VOXC_TRY(buffer.writable() ? Expected<Buffer *>(&buffer)
                                          : staging(uploadStaging_, BufferPlace::Upload));
  const auto flush = [&]() -> Expected<void> {
    const std::span<const VkBufferCopy> waiting = regions;
    auto done = waiting.empty() ? Expected<void>() : copy(*stage, buffer, waiting);
    regions.clear();
    staged = 0;
    return done;
  };
  for (const WordRange &range : ranges) {
    const auto bytes = std::as_bytes(words.subspan(range.first, range.end - range.first));
    const std::uint64_t at = range.first * sizeof(std::uint32_t);
    copied += bytes.size();
    if (staged + bytes.size() > kStagingBytes)
      VOXC_TRY(flush());
    if (buffer.writable() || bytes.size() > kStagingBytes) {
      VOXC_TRY(upload(bytes, buffer, at));
      continue;
    }
    std::memcpy(stage->writable() + staged, bytes.data(), bytes.size());
    regions.push_back({staged, at, bytes.size()});
    staged += bytes.size();
  }
  VOXC_TRY(flush());
  return copied;
}

Expected<void> Transfer::download(const Buffer &buffer, std::span<std::byte> bytes) {
  if (buffer.readable()) {
    std::memcpy(bytes.data(), buffer.readable(), bytes.size());
    return {};
  }
  auto stage = VOXC_TRY(staging(downloadStaging_, BufferPlace::Download));
  for (std::size_t offset = 0; offset < bytes.size(); offset += kStagingBytes) {
    std::size_t size = std::min(kStagingBytes, bytes.size() - offset);
    VOXC_TRY(copy(buffer, *stage, {offset, 0, size}));
    std::memcpy(bytes.data() + offset, stage->writable(), size);
  }
  return {};
}

Expected<Buffer *> Transfer::staging(std::optional<Buffer> &buffer, BufferPlace placement) {
  if (!buffer) {
    auto created = VOXC_TRY(
        Buffer::create(*device_, {.what = "staged copies", .bytes = kStagingBytes, .placement = placement}));
    buffer.emplace(std::move(created));
  }
  return &*buffer;
}

Expected<void> Transfer::copy(const Buffer &from, const Buffer &to, std::span<const VkBufferCopy> regions) {
  auto commands = VOXC_TRY(commands_.begin());
  device_->vk.CmdCopyBuffer(commands, from.get(), to.get(), static_cast<std::uint32_t>(regions.size()),
                            regions.data());
  recordBarrier(*device_, commands);
  VOXC_TRY(commands_.submit());
  return commands_.wait();
}

} // namespace voxc
