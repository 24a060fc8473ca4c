// The words, texts and dictionaries that MagicaVoxel's chunks are made of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace voxc {

/// Reads little-endian words and texts from the front of bytes. What is not there is 0 and makes it fail.
class VoxCursor {
public:
  explicit VoxCursor(std::span<const std::byte> bytes) : bytes_(bytes) {}

  bool failed() const { return failed_; }
  std::size_t size() const { return bytes_.size(); }

  std::span<const std::byte> take(std::uint64_t count) {
    if (count > bytes_.size()) {
      failed_ = true;
      bytes_ = {};
      return {};
    }
    const auto taken = bytes_.first(count);
    bytes_ = bytes_.subspan(count);
    return taken;
  }

  std::uint32_t word() {
    const auto bytes = take(4);
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
      value |= std::to_integer<std::uint32_t>(bytes[i]) << 8 * i;
    return value;
  }

  std::string_view text() {
    const auto bytes = take(word());
    return {reinterpret_cast<const char *>(bytes.data()), bytes.size()};
  }

  /// A count of things that take `bytesEach` or more: 0 if they cannot all be there.
  std::uint32_t count(std::uint32_t bytesEach) {
    const std::uint32_t value = word();
    if (value <= bytes_.size() / bytesEach)
      return value;
    failed_ = true;
    return 0;
  }

private:
  std::span<const std::byte> bytes_;
  bool failed_ = false;
};

/// Calls `visit(key, value)` for each pair of a dictionary.
template <typename Visit> void readDictionary(VoxCursor &cursor, Visit visit) {
  for (std::uint32_t pairs = cursor.count(8); pairs > 0 && !cursor.failed(); --pairs) {
    const std::string_view key = cursor.text();
    visit(key, cursor.text());
  }
}

} // namespace voxc
