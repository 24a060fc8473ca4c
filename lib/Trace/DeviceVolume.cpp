// The words of a volume on a device, where kernels read them.
#include "DeviceVolume.h"

#include <string>

namespace voxc {

std::uint64_t DeviceVolume::bytesFor(std::uint64_t words) { return VolumeWords::paddedBytes(words); }

Expected<DeviceVolume> DeviceVolume::upload(Device &device, const Volume &volume, Addressing addressing) {
  auto transfer = Transfer::create(device.state());
  if (!transfer)
    return transfer.error();
  auto words = VolumeWords::upload(device.state(), *transfer, volume.words(), addressing);
  if (!words)
    return words.error();
  auto state = std::make_shared<State>(State{volume.storageDigest(), toString(volume.format()), addressing});
  state->range = {words->binding().get(), 0, words->binding().bytes()};
  state->uploaded.emplace(std::move(*words));
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

BufferRange DeviceVolume::words() const { return state_->range; }

Addressing DeviceVolume::addressing() const { return state_->addressing; }

} // namespace voxc
