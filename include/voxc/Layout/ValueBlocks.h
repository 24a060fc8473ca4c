// Values apart: the values of all voxels by rank, in blocks that are decoded one voxel at a time.
//
// The section is a word for each block, where it begins, counted from the section's begin; then the blocks,
// equal ones once, and a last word without meaning, since values are read two words at a time. A block is
//
//   word 0   the least of each channel, a byte each, R lowest;
//   word 1   the bits that each channel takes (4 bits each, R lowest: 0 to 8); bit 16: R and B are stored as
//            their differences from G, modulo 256; bit 17: there are runs; bits 18 to 21: the bits of an
//            index, 0 without a palette; bits 24 to 31: the word at which the items begin;
//   then     with runs, 4 words of bits, of the values that differ from the one before, and of the first;
//   then     with a palette, an index for each value or, with runs, for each run;
//   then     the items: of the palette, or of the runs, or of all values, each the bits of its channels
//            above the least, R lowest.
//
// Which of runs and palette a block has is what takes the fewest words. The idea of blocks of bits by the
// rank of a voxel is that of Dolonius et al., "Compressing Color Data for Voxelized Surface Geometry" (I3D
// 2017); these are without loss.
#pragma once

#include "voxc/Layout/WordReader.h"

#include <cstdint>
#include <span>
#include <vector>

namespace voxc {

/// log2 of the values in a block, but for the last block.
inline constexpr int kLog2ValueBlock = 7;

/// A block of 1 to 2^kLog2ValueBlock values.
std::vector<std::uint32_t> encodeValueBlock(std::span<const std::uint32_t> values);

/// The value of the voxel of a rank, in the section at `section`. 0 where words outside are asked for.
std::uint32_t valueOfRank(const WordReader &words, std::uint64_t section, std::uint64_t rank);

/// Notes a problem unless the section at `section` is that of `voxels` values, all of it lies within the
/// words, and no value is 0, which is no voxel, unless values `mayBeZero` because they are codes of colours.
void checkValues(WordReader &words, std::uint64_t section, std::uint64_t voxels, bool mayBeZero);

} // namespace voxc
