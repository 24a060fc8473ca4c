// What a `DeviceVolume` holds.
#pragma once

#include "VolumeWords.h"

#include "voxc/Trace/Recorder.h"

#include <optional>
#include <string>

namespace voxc {

struct DeviceVolume::State {
  std::uint64_t storageDigest = 0;
  std::string format;
  voxc::Addressing addressing = Addressing::Buffer;
  BufferRange range = {};
  std::optional<VolumeWords> uploaded = {}; ///< Nothing where the words are the host's.
};

} // namespace voxc
