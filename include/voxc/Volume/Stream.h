// A stream: one named array of a volume, such as its words.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace voxc {

/// The name of the stream that every volume has, and has first.
inline constexpr std::string_view kWordStream = "words";

/// Elements of one size that lie one behind the other. The bytes belong to the volume.
struct Stream {
  std::string
      name; ///< 1 to 31 of a-z, 0-9 and '-', the first a letter; no other stream of the volume has it.
  std::uint32_t elementBytes = 1; ///< 1 to 256.
  std::span<const std::byte> bytes;
  std::uint64_t storedBytes = 0; ///< What it takes in the file that it was loaded from; 0: it was made.

  std::uint64_t elements() const { return bytes.size() / elementBytes; }

  /// The elements as values of a type of their size; none if they are of another size.
  template <typename T> std::span<const T> as() const {
    static_assert(std::is_trivially_copyable_v<T>);
    if (sizeof(T) != elementBytes)
      return {};
    return {reinterpret_cast<const T *>(bytes.data()), bytes.size() / sizeof(T)};
  }
};

/// The stream of a volume's words.
inline Stream wordStream(std::span<const std::uint32_t> words) {
  return {std::string(kWordStream), sizeof(std::uint32_t), std::as_bytes(words)};
}

} // namespace voxc
