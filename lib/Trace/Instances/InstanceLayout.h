// How instances, and what is known of rays among them, lie in buffers of words: as
// shaders-runtime/instances/world.glsl reads them.
#pragma once

#include "InstanceTree.h"

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace voxc {

/// An instance as a device has it.
struct InstanceRecord {
  glm::dmat4 fromWorld;
  std::uint32_t volume;
};

/// The words of the world: its header, the words of a ray of each volume's kernel, nodes, numbers of
/// instances that any ray may hit, and instances.
std::vector<std::uint32_t> worldWords(const InstanceTree &tree, std::span<const std::uint32_t> wordsOfRays,
                                      std::span<const InstanceRecord> instances);

/// Scratch memory for tiles of at most so many rays, a multiple of 64. Offsets and sizes are in words.
struct InstanceScratch {
  std::uint64_t volumes;
  std::uint64_t tileRays;

  static constexpr std::uint64_t kHeader = 16;
  static constexpr std::uint64_t kWordsOfState = 6;   ///< Of a ray, whatever the volumes are.
  static constexpr std::uint64_t kWordsOfVolume = 18; ///< Of a ray, for each volume.

  /// Three words with which dispatches over the rays that are not done are started.
  static constexpr std::uint64_t activeGroups() { return 0; }
  /// The same for the rays of a volume, and behind them their number.
  std::uint64_t starts(std::uint64_t volume) const { return kHeader + 4 * volume; }
  std::uint64_t header() const { return starts(volumes); }
  std::uint64_t rays(std::uint64_t volume) const {
    return state() + kWordsOfState * tileRays + volume * (kWordsOfVolume * tileRays + 64);
  }
  std::uint64_t hits(std::uint64_t volume) const { return rays(volume) + 8 * tileRays; }
  std::uint64_t deferred(std::uint64_t volume) const { return rays(volume) + 17 * tileRays; }
  std::uint64_t all() const { return rays(volumes); }

  /// The largest that has room in so many words; none: `tileRays` is 0.
  static InstanceScratch within(std::uint64_t words, std::uint64_t volumes) {
    const std::uint64_t fixed = InstanceScratch{volumes, 0}.all();
    const std::uint64_t ofRay = kWordsOfState + volumes * kWordsOfVolume;
    return {volumes, words < fixed ? 0 : (words - fixed) / ofRay / 64 * 64};
  }

private:
  std::uint64_t state() const { return (header() + 63) / 64 * 64; }
};

} // namespace voxc
