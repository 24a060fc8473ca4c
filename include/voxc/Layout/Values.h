// Values apart: the values of all voxels by rank, behind all nodes, coded as the payload asks for.
//
// Word 1 of a volume says where their section begins. It is one of blocks of 2^kLog2ValueBlock values each:
// of colours (voxc/Layout/ValueBlocks.h) or of indices into a table of them (voxc/Layout/PaletteBlocks.h).
#pragma once

#include "voxc/Layout/Layout.h"
#include "voxc/Layout/WordReader.h"

#include <cstdint>
#include <functional>

namespace voxc {

/// The value of the voxel of a rank, of a volume whose values stand apart. 0 where words outside are asked
/// for.
std::uint32_t valueOfRank(const WordReader &words, Payload payload, std::uint64_t rank);

/// The value of a voxel, of which a cell says `value`, and nodes that it has this rank.
std::uint32_t valueOfVoxel(const WordReader &words, const Layout &layout, std::uint32_t value,
                           std::uint64_t rank);

/// What a payload that rounds colours makes of one; none of others, which keep them.
std::function<std::uint32_t(std::uint32_t)> roundingOf(Payload payload);

/// Notes a problem unless the section is that of `voxels` values, and all of it lies within the words.
void checkValues(WordReader &words, const Layout &layout, std::uint64_t voxels);

} // namespace voxc
