// What the rays of a packet do at once.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace voxc {

/// Turns of loops in which rays of a packet have been, and how deep they went. Nearly so: of two turns whose
/// numbers collide, one may be begun again.
class PacketTurns {
public:
  /// Forgets all turns.
  void clear() { ++packet_; }

  /// What a look-up adds to those of the packet's other rays in the same turn.
  struct Added {
    bool isFirst; ///< There was none.
    int layers;   ///< By how many it goes deeper than any.
  };
  Added add(std::uint64_t turn, int layers) {
    const std::uint64_t mixed = (turn * 0x9e3779b97f4a7c15u) ^ packet_ * 0xd6e8feb86659fd93u;
    const std::uint64_t key = mixed & ~kLayers;
    std::uint64_t &entry = entries_[mixed >> (64 - kLog2Entries)];
    const int before = (entry & ~kLayers) == key ? static_cast<int>(entry & kLayers) : kNone;
    if (layers > before)
      entry = key | static_cast<std::uint64_t>(layers);
    return {before == kNone, std::max(layers - std::max(before, 0), 0)};
  }

private:
  static constexpr int kLog2Entries = 12;
  /// Bits of an entry that tell the layers, of which there are 21 at most.
  static constexpr std::uint64_t kLayers = 31;
  static constexpr int kNone = -1;

  std::uint64_t packet_ = 1;
  std::array<std::uint64_t, std::size_t{1} << kLog2Entries> entries_{};
};

} // namespace voxc
