// Values apart that are few colours: a table of them, and for each voxel an index into it, in blocks that are
// decoded one voxel at a time.
//
// The section is a word, the number of colours (bits 0 to 23) and the bits of an entry (24 to 31); the
// colours; an entry for each block of 2^kLog2ValueBlock voxels, one behind the other; the blocks, equal ones
// once; and a last word without meaning, since fields are read two words at a time. An entry is an offset
// from the section's begin: of a colour, which all voxels of the block have, or of the block. A block is
//
//   word 0   bits 0 to 15: the least index; 16 to 20: the bits of an item, 0 to 16; bit 21: a mask marks
//   runs;
//            bit 22: begins mark runs; 24 to 31: how many items the palette has, 0 without one, or how many
//            runs begins mark, at most 32;
//   then     with a mask, 4 words of bits, of the voxels that differ from the one before, and of the first;
//   then     one behind the other, as bits: with begins, 7 bits for each run but the first, at which voxel it
//            begins; the items: of the palette, of the runs, or of all voxels, each an index above the least;
//            with a palette, where its item stands there for each voxel or, with a mask, for each run, in as
//            few bits as number the palette.
//
// Which of them a block has is what takes the fewest words.
#pragma once

#include "voxc/Layout/WordReader.h"

#include <cstdint>
#include <span>
#include <vector>

namespace voxc {

/// The most colours that a table may have: indices have 16 bits.
inline constexpr std::uint32_t kMostPaletteColours = 1u << 16;

/// A block of 1 to 2^kLog2ValueBlock indices below kMostPaletteColours.
std::vector<std::uint32_t> encodeIndexBlock(std::span<const std::uint32_t> indices);

/// The head of a section and its colours; what `entryBits` says of each entry's bits is for `packEntries`.
std::vector<std::uint32_t> paletteHead(std::span<const std::uint32_t> colours, int entryBits);

/// The bits of an entry in a section of so many colours, blocks (with those of one colour) and words of
/// different blocks. More than 32: too many words.
int entryBitsOf(std::uint64_t colours, std::uint64_t blocks, std::uint64_t blockWords);

/// Packs entries, of `bits` bits each, into the first of the words that they stand in; the words they take.
std::uint64_t packEntries(std::span<std::uint32_t> entries, int bits);

/// The colour of the voxel of a rank, in the section at `section`. 0 where words outside are asked for.
std::uint32_t colourOfRank(const WordReader &words, std::uint64_t section, std::uint64_t rank);

/// Notes a problem unless the section at `section` has at most `mostColours` colours and is that of `voxels`
/// voxels, all of it within the words, and no index is past the table.
void checkPalette(WordReader &words, std::uint64_t section, std::uint64_t voxels, std::uint64_t mostColours);

/// How many colours the table of the section at `section` has.
std::uint64_t paletteColours(const WordReader &words, std::uint64_t section);

} // namespace voxc
