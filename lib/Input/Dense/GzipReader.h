// Inflating gzip data piece by piece, never more than is asked for.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"
#include "voxc/Support/WorkingMemory.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace voxc {

using InflatedBytes = ScratchArray<std::byte>;

/// True if the bytes begin as gzip data does.
bool isGzip(std::span<const std::byte> bytes);

/// Inflates the members of gzip data, one after the other.
class GzipReader {
public:
  /// What stands around deflated data. Of zlib's, and without any, there is but one member.
  enum class Wrapping { Gzip, Zlib, None };

  /// `bytes` must outlive the reader.
  explicit GzipReader(std::span<const std::byte> bytes, Wrapping wrapping = Wrapping::Gzip);
  ~GzipReader();
  GzipReader(const GzipReader &) = delete;
  GzipReader &operator=(const GzipReader &) = delete;

  /// Fills `target`, or as much of it as there is left, and returns how much that was. Error: damaged data.
  Expected<std::size_t> readSome(std::span<std::byte> target);

  /// Fills `target`. Errors: damaged data, or an end before that.
  Expected<void> read(std::span<std::byte> target);

  /// Reads `count` bytes into memory, which is not taken if so many cannot be in the data. Errors: as `read`;
  /// no memory; interrupted.
  Expected<std::shared_ptr<const InflatedBytes>>
  read(std::uint64_t count, const std::shared_ptr<WorkingMemory> &memory, const Progress &progress);

  /// Once the end was read: the bytes behind it, which are no gzip data.
  std::span<const std::byte> behind() const { return bytes_; }

private:
  struct State;

  std::span<const std::byte> bytes_; ///< What is not inflated yet.
  std::unique_ptr<State> state_;
};

} // namespace voxc
