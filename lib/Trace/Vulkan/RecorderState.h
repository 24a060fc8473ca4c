// What recorders and the traces that they bind hold.
#pragma once

#include "TracePipeline.h"

#include "voxc/Trace/Recorder.h"

#include <string_view>

namespace voxc {

struct TraceRecorder::State {
  Device::State *device;
  TracePipeline pipeline;
  std::uint64_t storageDigest;
  Addressing addressing;
  Counted counted;
  unsigned resumes;         ///< 0 where no loop is cut short.
  std::uint64_t bytesOfRay; ///< As the kernel takes it.
};

struct BoundTrace::State {
  std::shared_ptr<const TraceRecorder::State> recorder;
  std::shared_ptr<const DeviceVolume::State> volume;
  BoundBuffers buffers;
  std::uint32_t rays;
  std::uint32_t tileRays; ///< So many at once.
};

/// A range as descriptors have it.
VkDescriptorBufferInfo descriptorOf(const BufferRange &range);

/// Checks a range of a host's buffer that is to hold at least so many bytes. Error (`Usage`), naming it: it
/// is empty, too small, out of line or larger than the device reaches.
Expected<void> checkRange(const Device::State &device, std::string_view what, const BufferRange &range,
                          std::uint64_t leastBytes);

} // namespace voxc
