// Blocks of voxels by their mean colours: what may be shown of a volume whose pages are not there.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"
#include "voxc/Volume/PagedVolume.h"
#include "voxc/Volume/Volume.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// A block that has voxels, as it lies in a file: 16 bytes, little-endian.
struct CoarseBlock {
  std::uint64_t code = 0; ///< `mortonCode` of its place, counted in blocks.
  std::uint32_t rgba = 0; ///< The mean of its voxels, each byte rounded to nearest.
  std::uint32_t box = 0;  ///< Where in the block they are: `packBox`.

  bool operator==(const CoarseBlock &) const = default;
};
static_assert(sizeof(CoarseBlock) == 16);

/// The least and the greatest coordinates of voxels within a block, 0 to side - 1.
struct CoarseBox {
  Int3 low;
  Int3 high;

  bool operator==(const CoarseBox &) const = default;
};

/// Six numbers of five bits: low x, y, z, then high x, y, z, from bit 0 on.
std::uint32_t packBox(const CoarseBox &box);
CoarseBox unpackBox(std::uint32_t packed);

/// Blocks are of 4, 8, 16 or 32 voxels a side.
inline constexpr int kLeastLog2CoarseSide = 2;
inline constexpr int kMostLog2CoarseSide = 5;
/// 2 GiB of them.
inline constexpr std::uint64_t kMostCoarseBlocks = std::uint64_t{1} << 27;

/// All blocks of a volume that have voxels. Every voxel is in the box of its block.
struct CoarseBlocks {
  int log2Side = kMostLog2CoarseSide;
  std::vector<CoarseBlock> blocks; ///< Their codes rise strictly.

  bool operator==(const CoarseBlocks &) const = default;
};

/// Finds the blocks of 2^log2Side voxels a side. Errors: `Usage`, the voxels are labels, which have no mean,
/// or there are more than `kMostCoarseBlocks`; as `decode`.
Expected<CoarseBlocks> makeCoarseBlocks(const Volume &volume, int log2Side, const Progress &progress = {});

/// The stream that blocks of this side are kept in: "coarse-4" to "coarse-32".
std::string coarseStreamName(int log2Side);
/// log2 of the side that the name of a stream gives; nothing if it is another stream.
std::optional<int> coarseSideOf(std::string_view streamName);

/// A volume of the same words with these blocks, and no others. It keeps `volume`. Error (`Usage`): it has no
/// room for a stream more.
Expected<Volume> withCoarseBlocks(std::shared_ptr<const Volume> volume, CoarseBlocks blocks);

/// The blocks of a volume, if it has some. What they say of its voxels is not compared with these. Error
/// (`Input`): they are not well-formed.
Expected<std::optional<CoarseBlocks>> coarseBlocksOf(const Volume &volume);

/// Decodes the blocks of a file; memory grows with what was found well-formed. Errors: `Usage`, it has none;
/// `Input`, they are damaged or not well-formed.
Expected<CoarseBlocks> readCoarseBlocks(const PagedVolume &volume);

} // namespace voxc
