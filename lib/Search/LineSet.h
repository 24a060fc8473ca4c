// The cache lines that a packet has read.
#pragma once

#include <array>
#include <cstdint>

namespace voxc {

/// Counts different lines, nearly so: of two whose numbers collide, one may be counted again.
class LineSet {
public:
  /// Forgets all lines.
  void clear() { ++packet_; }

  /// True if the line was not read since.
  bool add(std::uint64_t line) {
    const std::uint64_t key = (line * 0x9e3779b97f4a7c15u) ^ packet_ * 0xd6e8feb86659fd93u;
    std::uint64_t &entry = entries_[key >> (64 - kLog2Entries)];
    const bool isNew = entry != key;
    entry = key;
    return isNew;
  }

private:
  static constexpr int kLog2Entries = 13;

  std::uint64_t packet_ = 1;
  std::array<std::uint64_t, std::size_t{1} << kLog2Entries> entries_{};
};

} // namespace voxc
