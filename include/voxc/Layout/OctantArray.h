// The array of small grids by octants. A grid of 4 x 4 x 4 voxels has a byte that says which of its eight
// octants of 2 x 2 x 2 cells are not empty, and for each of these a byte that marks its cells, all in Morton
// order. Sixteen grids are a group, whose head has a word that says at which byte of the array the cells of
// the first begin, those of the others following, and then the bytes of octants, four a word; the last head
// ends with the last grid. The cells of all groups stand behind all heads.
#pragma once

#include "voxc/Layout/WordReader.h"
#include "voxc/Support/FunctionRef.h"

#include <cstdint>
#include <span>

namespace voxc {

/// A grid of such an array.
struct OctantGrid {
  std::uint32_t octants = 0; ///< A bit for each that is not empty.
  std::uint64_t cells = 0;   ///< The byte of the words at which their cells begin.
};

/// How many words an array of so many grids takes, which have so many octants that are not empty.
std::uint64_t octantArrayWords(std::uint64_t grids, std::uint64_t octants);

/// Writes the array of grids of two words each, a bit a cell in Morton order, by giving its words to `put`
/// one after the other. There are at most 2^24 grids.
void writeOctantArray(std::span<const std::uint32_t> grids, FunctionRef<void(std::uint32_t)> put);

/// The grid of a number, from 1 on, in the array that begins at word `array`. The words need not have been
/// checked: what lies outside reads as 0.
OctantGrid octantGrid(const WordReader &words, std::uint64_t array, std::uint64_t number);

/// True if all words that the grid of a number speaks of are there, and no octant that it names is empty.
/// Else a problem is noted. `ranked`: kernels count its cells, and read a word behind them.
bool checkOctantGrid(WordReader &words, std::uint64_t array, std::uint64_t number, bool ranked);

/// The cells of a grid, a bit each in Morton order.
std::uint64_t cellsOf(const WordReader &words, const OctantGrid &grid);

} // namespace voxc
