// The words of a volume on a device, where kernels read them.
#include "DeviceVolume.h"

#include "Trace/Kernel/KernelFit.h"

#include <algorithm>
#include <string>

namespace voxc {

std::uint64_t DeviceVolume::bytesFor(std::uint64_t words) { return VolumeWords::paddedBytes(words); }

Expected<DeviceVolume> DeviceVolume::upload(Device &device, const Volume &volume, Addressing addressing) {
  auto transfer = VOXC_TRY(Transfer::create(device.state()));
  auto words = VOXC_TRY(VolumeWords::upload(device.state(), transfer, volume.words(), addressing));
  auto state = std::make_shared<State>(State{volume.storageDigest(), toString(volume.format()), addressing});
  state->range = {words.binding().get(), 0, words.binding().bytes()};
  state->uploaded.emplace(std::move(words));
  return DeviceVolume(std::move(state));
}

Expected<DeviceVolume> DeviceVolume::in(const BufferRange &words, const Volume &volume) {
  const std::uint64_t needed = bytesFor(volume.words().size());
  if (words.bytes < needed)
    return Error::usage("the words of this volume take " + std::to_string(needed) +
                        " bytes, but the host's range has " + std::to_string(words.bytes));
  auto state =
      std::make_shared<State>(State{volume.storageDigest(), toString(volume.format()), Addressing::Buffer});
  state->range = {words.buffer, words.offset, needed};
  return DeviceVolume(std::move(state));
}

Expected<DeviceVolume> DeviceVolume::withRoom(const BufferRange &room, const Volume &volume) {
  VOXC_TRY(in(room, volume));
  return DeviceVolume(std::make_shared<State>(
      State{volume.storageDigest(), toString(volume.format()), Addressing::Buffer, room}));
}

namespace {

/// What a command holds at most, so that little is copied twice.
constexpr std::uint64_t kPieceWords = 1024;

/// Orders what reads the words before and after they change.
void recordOrder(const Device::State &device, VkCommandBuffer commands, VkPipelineStageFlags before,
                 VkPipelineStageFlags after, VkMemoryBarrier barrier) {
  barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
  device.vk.CmdPipelineBarrier(commands, before, after, 0, 1, &barrier, 0, nullptr, 0, nullptr);
}

} // namespace

Expected<std::uint64_t> recordUpdate(Device &device, VkCommandBuffer commands, const DeviceVolume &volume,
                                     const Volume &after, std::span<const WordRange> changed) {
  const DeviceVolume::State &state = *volume.state();
  VOXC_TRY(checkFit(state.storageDigest, after, "spirv"));
  const auto words = after.words();
  if (state.uploaded || state.range.bytes < DeviceVolume::bytesFor(words.size()))
    return Error::usage("the words take " + std::to_string(DeviceVolume::bytesFor(words.size())) +
                        " bytes now, but the host's range has " + std::to_string(state.range.bytes) +
                        "; one with more room is bound anew");
  constexpr VkPipelineStageFlags kCompute = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
  constexpr VkPipelineStageFlags kTransfer = VK_PIPELINE_STAGE_TRANSFER_BIT;
  recordOrder(device.state(), commands, kCompute | kTransfer, kTransfer,
              {.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT, .dstAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT});
  std::uint64_t bytes = 0;
  for (const WordRange &range : changed)
    for (std::uint64_t first = range.first; first < range.end; first += kPieceWords) {
      const auto piece = words.subspan(first, std::min(kPieceWords, range.end - first));
      device.state().vk.CmdUpdateBuffer(commands, state.range.buffer,
                                        state.range.offset + first * sizeof(std::uint32_t),
                                        piece.size_bytes(), piece.data());
      bytes += piece.size_bytes();
    }
  recordOrder(device.state(), commands, kTransfer, kCompute,
              {.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT, .dstAccessMask = VK_ACCESS_SHADER_READ_BIT});
  return bytes;
}

BufferRange DeviceVolume::words() const { return state_->range; }

Addressing DeviceVolume::addressing() const { return state_->addressing; }

} // namespace voxc
