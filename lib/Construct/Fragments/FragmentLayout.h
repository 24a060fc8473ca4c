// How fragments lie in their files (docs/hvf.md); little-endian, no padding.
#pragma once

#include "Construct/Nodes/NodeStore.h"

#include "voxc_host.h"

#include <array>
#include <cstdint>

namespace voxc::hvf {

inline constexpr std::array<char, 8> kMagic = {'\x89', 'H', 'V', 'F', '\r', '\n', '\x1a', '\n'};
inline constexpr std::uint32_t kVersion = 6;
/// Fragments of earlier versions do not say whether they are whole.
inline constexpr std::uint32_t kFirstWholeVersion = 5;
inline constexpr std::uint32_t kByteOrder = 0x01020304;

/// The fixed part of the header. The texts follow, then the parts, then the trailer.
struct Header {
  std::array<char, 8> magic = kMagic;
  std::uint32_t version = kVersion;
  std::uint32_t byteOrder = kByteOrder;
  std::uint64_t checksum = 0; ///< XXH3-64 of all that follows the header, then of the header with 0 here.
  std::uint64_t parts = 0;
  std::uint64_t index = 0;
  std::uint64_t count = 0;
  std::uint64_t begin = 0; ///< The cubes of the fragment's share: [begin, end),
  std::uint64_t end = 0;
  std::uint64_t looked = 0; ///< and how many of them were looked at.
  std::uint64_t voxels = 0; ///< Of all parts.
  std::array<std::int32_t, 3> extent{};
  std::int32_t log2Side = 0;
  std::uint32_t irBytes = 0;
  std::uint32_t provenanceBytes = 0;
  std::array<double, 12> voxelToModel{};
};
static_assert(sizeof(Header) == 200);

inline constexpr std::array<char, 8> kTrailerMagic = {'\x89', 'H', 'V', 'F', 'e', 'n', 'd', '\n'};

/// The last bytes of a file that was written to its end.
struct Trailer {
  std::array<char, 8> magic = kTrailerMagic;
  std::uint64_t bytes = 0; ///< Of the file, this one among them.
};
static_assert(sizeof(Trailer) == 16);

/// What stands before each part; its words, array, blocks (a word of 8 bytes each), cells and values follow.
struct PartHeader {
  std::array<std::int32_t, 3> low{};
  std::array<std::uint32_t, 3 + construct::kMaskWords> node{}; ///< Kind, value, masks, voxels.
  std::uint32_t colour = 0;                                    ///< Of all voxels, of payload=constant.
  std::int32_t log2Side = 0;                                   ///< Of the part.
  std::uint64_t words = 0;
  std::uint64_t array = 0;
  std::uint64_t blocks = 0;
  std::uint64_t cells = 0;
  std::uint64_t values = 0;
  std::uint64_t voxels = 0;
};
static_assert(sizeof(PartHeader) == 96);
static_assert(sizeof(construct::PlacedCell) == 20);

inline constexpr int kKindBits = 2;
inline constexpr int kLevelBits = 6;

/// A block as it stands in a file, and back.
inline std::uint64_t pack(const BlockRecord &block) {
  return block.kind | block.level << kKindBits | block.words << (kKindBits + kLevelBits);
}

inline BlockRecord unpack(std::uint64_t packed) {
  return {static_cast<BlockRecord::Kind>(packed & ((1u << kKindBits) - 1)),
          static_cast<std::uint32_t>(packed >> kKindBits & ((1u << kLevelBits) - 1)),
          packed >> (kKindBits + kLevelBits)};
}

} // namespace voxc::hvf
