// The words of a volume on a device.
#pragma once

#include "Buffer.h"
#include "Transfer.h"

#include "voxc/Trace/Kernel.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace voxc {

/// One buffer, or segments of 2^28 words and a table of their addresses. Segments without anything
/// are one, so that a volume which is mostly empty takes no more of the device than it holds.
class VolumeWords {
public:
  /// Errors: `Environment`, naming the sizes, if the device cannot hold them in this way.
  static Expected<VolumeWords> upload(Device::State &device, Transfer &transfer,
                                      std::span<const std::uint32_t> words, Addressing addressing);

  /// Takes the words `after` in place of `before`, which must be those that are there: copies the blocks that
  /// differ, and makes room where there are more. Nothing may be running. `binding` may be another then.
  /// Errors: as `upload`.
  Expected<UpdateReport> update(Transfer &transfer, std::span<const std::uint32_t> before,
                                std::span<const std::uint32_t> after);

  /// The same where it is known which words of `after` are others: those alone are copied.
  Expected<UpdateReport> follow(Transfer &transfer, std::span<const std::uint32_t> after,
                                std::span<const WordRange> changed);

  /// How many there are.
  std::uint64_t count() const { return count_; }

  /// What kernels find at binding 2: the words, or the table.
  const Buffer &binding() const { return table_ ? *table_ : *parts_.front(); }

  /// The bytes of a buffer for so many words: whole groups of four, so that kernels may load them so.
  static constexpr std::uint64_t paddedBytes(std::uint64_t words) { return (words + 3) / 4 * 16; }

private:
  using Part = std::shared_ptr<Buffer>;

  VolumeWords(Device::State &device, Addressing addressing) : device_(&device), addressing_(addressing) {}
  /// The words of a part: all of them, or those of a segment.
  std::uint64_t partWords() const;
  Expected<std::uint64_t> updatePart(Transfer &transfer, Part &part, std::span<const std::uint32_t> before,
                                     std::span<const std::uint32_t> after);
  Expected<std::uint64_t> followPart(Transfer &transfer, Part &part, std::span<const std::uint32_t> after,
                                     std::span<const WordRange> changed);
  Expected<UpdateReport> updated(Transfer &transfer, std::uint64_t words, UpdateReport report);
  Expected<void> makeRoom(Transfer &transfer, Part &part, std::uint64_t words);
  Expected<void> uploadTable(Transfer &transfer);

  Device::State *device_;
  Addressing addressing_;
  std::uint64_t count_ = 0;
  std::vector<Part> parts_; ///< One, or the segments.
  Part zeros_;              ///< The segment that all those are which hold nothing.
  std::optional<Buffer> table_;
};

} // namespace voxc
