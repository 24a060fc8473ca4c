// The words of a volume on a device.
#pragma once

#include "Buffer.h"
#include "Transfer.h"

#include "voxc/Trace/Kernel.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace voxc {

/// One storage buffer, or segments of 2^28 words and a table of their addresses. Segments without anything
/// are one, so that a volume which is mostly empty takes no more of the device than it holds.
class VolumeWords {
public:
  /// Errors: `Environment`, naming the sizes, if the device cannot hold them in this way.
  static Expected<VolumeWords> upload(Device::State &device, Transfer &transfer,
                                      std::span<const std::uint32_t> words, Addressing addressing);

  /// What kernels find at binding 2: the words, or the table.
  const Buffer &binding() const { return table_ ? *table_ : segments_.front(); }

  /// The bytes of a buffer for so many words: whole groups of four, so that kernels may load them so.
  static constexpr std::uint64_t paddedBytes(std::uint64_t words) { return (words + 3) / 4 * 16; }

private:
  Expected<void> uploadSegments(Device::State &device, Transfer &transfer,
                                std::span<const std::uint32_t> words);

  std::vector<Buffer> segments_;
  std::optional<Buffer> table_;
};

} // namespace voxc
