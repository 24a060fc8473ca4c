// Facts about voxels that should drive the choice of a format, measured on their source.
#pragma once

#include "voxc/Source/VoxelSource.h"
#include "voxc/Support/Progress.h"
#include "voxc/Support/WorkingMemory.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace voxc {

/// How many different things there are: counted, or estimated where there are more than are kept. The
/// estimate is adaptive sampling (Wegman; Flajolet, "On adaptive sampling", Computing 43, 1990), whose
/// standard error is 1.2 / sqrt(things kept).
struct DistinctCount {
  std::uint64_t count = 0;
  bool exact = true; ///< False: estimated.

  bool operator==(const DistinctCount &) const = default;
};

/// The aligned cubes of 2^height voxels a side that are not empty. Cells outside the extent are empty.
struct HeightFacts {
  std::uint64_t occupied = 0;  ///< With a voxel at least.
  std::uint64_t full = 0;      ///< Of these: without an empty cell.
  std::uint64_t oneColour = 0; ///< Whose voxels have all one word, be there empty cells or not.
  std::uint64_t uniform = 0;   ///< Both full and of one colour: what a tree keeps as one leaf.

  bool operator==(const HeightFacts &) const = default;
};

/// How the voxels are spread over the cube of 2^max(2, log2Extent) cells a side at the origin, cut into
/// 4 x 4 x 4 regions.
struct RegionFacts {
  int log2Side = 0;                       ///< Of a region.
  std::array<std::uint64_t, 64> voxels{}; ///< In region (x, y, z): at x + 4 * (y + 4 * z).
};

/// The values of one channel, 0 to 255, over all voxels.
struct ChannelFacts {
  int least = 0;
  int greatest = 0;
  double mean = 0;
};

/// The colours of voxels: their words. All is 0 where there are no voxels.
struct ColourFacts {
  DistinctCount words; ///< Different words: R, G, B and alpha.
  DistinctCount rgb;   ///< Different R, G and B, whatever the alpha.
  /// Zeroth-order entropy of the words, in bits a voxel (Shannon 1948): sum of -p log2 p over their shares p.
  double entropy = 0;
  /// False: there are more words than are counted one by one, and `entropy` is that of groups of words,
  /// chosen by a hash. It is a lower bound: joining outcomes never adds entropy.
  bool entropyExact = true;
  std::array<ChannelFacts, 4> channels; ///< Of R, G, B and alpha.
  int alphas = 0;                       ///< Different values of alpha.
  std::uint64_t opaque = 0;             ///< Voxels with an alpha of 255.
  std::uint64_t transparent = 0;        ///< Voxels with an alpha of 0.
  std::uint64_t repeats = 0;            ///< Voxels with the word of the voxel before, in Morton order.
  double perBlock4 = 0; ///< Different words in an aligned block of 4^3 cells: mean over those not empty.
  double perBlock8 = 0; ///< The same in 8^3.
  double perRun256 = 0; ///< The same in 256 consecutive voxels in Morton order; the last run may be shorter.

  /// Bits of an index into a palette of all words; 0 for one word or none.
  int indexBits() const;
};

/// How many different blocks there are among the aligned cubes of 2^height voxels a side that are not empty:
/// what a DAG shares. Blocks are compared by digests of 64 bits, so that two in 2^64 may be taken for one.
struct RepetitionFacts {
  int height = 0;
  std::uint64_t blocks = 0; ///< Cubes that are not empty.
  DistinctCount shapes;     ///< By which cells are empty.
  DistinctCount mirrored; ///< The same, but blocks that mirroring in x, y, z or several makes equal are one.
  DistinctCount coloured; ///< By which cells are empty, and the words of the others.
};

struct Facts {
  Int3 extent;        ///< Of the source.
  int log2Extent = 0; ///< log2 of the side of the smallest cube of a power of two that holds the extent.
  std::uint64_t voxels = 0;
  Int3 boxLow;  ///< The smallest box around all voxels: its first cell,
  Int3 boxHigh; ///< and the cell behind its last one. Both are 0 where there are no voxels.
  /// Voxels whose six face neighbours are voxels too; cells outside the extent are empty.
  std::uint64_t interior = 0;
  std::vector<HeightFacts> heights; ///< By height, 0 to log2Extent.
  RegionFacts regions;
  ColourFacts colours;
  std::vector<RepetitionFacts> repetition; ///< Of heights 1 to 6, as far as log2Extent goes.

  /// Share of the cells of the smallest box that are voxels, 0 to 1.
  double fill() const;
  /// Share of voxels that are interior, 0 to 1.
  double interiorShare() const;
  /// Mean number of cubes that are not empty in one of twice their side: 1 to 8; 0 for height 0 or no voxels.
  double branching(int height) const;
};

/// What bounds the memory of measuring.
struct FactsOptions {
  /// Different words that are counted one by one, at most; beyond, `ColourFacts` says what becomes of them.
  /// 64 bytes each.
  std::size_t mostWords = std::size_t{1} << 20;
  /// Different blocks that are kept of each kind and height, at most; beyond, they are estimated. There are
  /// 18 such sets, with 24 bytes for each block.
  std::size_t mostBlocks = std::size_t{1} << 17;
  /// For the bricks that wait for their neighbours: 104 bytes and more for each of 8^3 voxels that lies on
  /// the border between what was read and what was not. Null: `WorkingMemory::createDefault()`.
  std::shared_ptr<WorkingMemory> memory;
};

/// Measures all voxels of a source in one pass in Morton order. Errors: that of a source that fails,
/// interrupted, or no memory or scratch file (`Environment`).
Expected<Facts> measureFacts(VoxelSource &source, const FactsOptions &options = {},
                             const Progress &progress = {});

} // namespace voxc
