// Minecraft's schematics as boxes of blocks.
#pragma once

#include "Input/Minecraft/Nbt.h"
#include "voxc/Support/Progress.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace voxc {

/// How the numbers of blocks are stored, x fastest, then z, then y.
enum class BlockCoding : std::uint8_t {
  Varint, ///< Seven bits a byte, the low ones first.
  Packed, ///< So many bits each, across big-endian longs.
  Bytes,  ///< A byte each, and perhaps four more bits in an array of their own.
};

/// Air is many blocks of few bytes, so that whoever goes through them looks at whether to stop.
inline constexpr std::uint64_t kBlocksBetweenLooks = 1 << 16;

/// In place of the word of a number that the palette lacks. Words of blocks are opaque.
inline constexpr std::uint32_t kNoBlock = 1;

/// A box of blocks.
struct BlockRegion {
  std::array<std::int64_t, 3> low{};
  std::array<std::int64_t, 3> size{};
  std::vector<std::uint32_t> words; ///< By the number of a block; 0 for air, or `kNoBlock`.
  BlockCoding coding = BlockCoding::Varint;
  unsigned bits = 0; ///< Of `Packed`.
  std::span<const std::byte> data;
  std::span<const std::byte>
      more; ///< Of `Bytes`: the bits above, two blocks a byte, the first in the low ones.
  std::span<const std::byte>
      kinds; ///< Of `Bytes`: which of 16 kinds of a number a block is, in the low bits.

  /// Blocks in all. At most 2^40, which was proven.
  std::uint64_t count() const {
    return static_cast<std::uint64_t>(size[0]) * static_cast<std::uint64_t>(size[1]) *
           static_cast<std::uint64_t>(size[2]);
  }

  /// Of `Bytes`, whose arrays are long enough: a number of 12 bits, and behind it a kind of 4. Of a plant of
  /// two blocks the upper one has the kind of the lower one.
  std::uint32_t numberAt(std::size_t block) const;
  /// The same of each block as it stands there.
  std::uint32_t storedAt(std::size_t block) const;

  /// Calls `visit(cell, word)` for each block that is no air, `cell` from (0, 0, 0) on. Errors: fewer numbers
  /// than blocks; a number that is none of the palette's; interrupted.
  Expected<void>
  forEachBlock(const Progress &progress,
               FunctionRef<void(const std::array<std::int64_t, 3> &cell, std::uint32_t word)> visit) const;
};

struct BlockScene {
  std::vector<BlockRegion> regions;
  std::vector<std::string> warnings;
};

/// The boxes of a Sponge schematic (.schem, versions 1 to 3), a Litematica file (.litematic) or a schematic
/// of old (.schematic), whichever the tags are. They point into `file`'s bytes. Errors: none of these; what a
/// box needs is missing, or is larger than its data; a palette of more than 2^20 kinds, or of two for one
/// number; interrupted.
Expected<BlockScene> readBlockScene(const NbtTag &file, const Progress &progress);

} // namespace voxc
