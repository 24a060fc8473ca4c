// A file of records as an array, which the system reads when it is looked at.
#pragma once

#include "voxc/Support/Error.h"

#include <cstddef>
#include <span>
#include <string>
#include <utility>

namespace voxc::gpu {

/// The bytes of a file, which must not change meanwhile.
class MappedBytes {
public:
  static Expected<MappedBytes> open(const std::string &path);
  MappedBytes(MappedBytes &&other) noexcept : bytes_(std::exchange(other.bytes_, {})) {}
  MappedBytes &operator=(MappedBytes &&) = delete;
  ~MappedBytes();

  std::span<const std::byte> bytes() const { return bytes_; }
  /// As records of one type; what is left behind the last is left out.
  template <typename Record> std::span<const Record> as() const {
    return {reinterpret_cast<const Record *>(bytes_.data()), bytes_.size() / sizeof(Record)};
  }

private:
  explicit MappedBytes(std::span<const std::byte> bytes) : bytes_(bytes) {}
  std::span<const std::byte> bytes_;
};

} // namespace voxc::gpu
