// Sub-volumes of any stratum: looked up, visited and checked, and moved, by the record alone.
#pragma once

#include "voxc/Layout/SlotKind.h"
#include "voxc/Layout/Stratum.h"
#include "voxc/Layout/WordReader.h"
#include "voxc/Support/FunctionRef.h"

#include <cstdint>
#include <span>

namespace voxc {

/// The value of a cell, or of all cells of a leaf, that a node holds.
std::uint32_t cellValue(const WordReader &words, const Stratum &stratum, const Child &leaf);

/// In a ranked stratum, how many voxels of a node come before those of a child of 2^log2Child cells a side.
std::uint64_t voxelsBefore(const Child &child, int log2Child);

/// In a ranked stratum, how many voxels of a leaf of 2^log2Child cells a side come before those of `cell`,
/// and how many each of its cells has.
Ranks ranksInLeaf(const Stratum &stratum, const Child &leaf, int log2Child, Int3 cell);

/// The value of `cell` in the sub-volume at `offset`, and the empty or uniform cube around it. The words must
/// have been checked.
Lookup lookUp(const WordReader &words, const Stratum &stratum, std::uint64_t offset, Int3 cell);

/// Receives cells within a window that have one value that is not 0, and how many voxels of the sub-volume
/// come before the first of them. In ranked strata each cell has `each` voxels.
using WindowVisit =
    FunctionRef<void(const Cube &cube, std::uint32_t value, std::uint64_t rank, std::uint64_t each)>;

/// Visits the non-empty cells of the sub-volume at `offset` that lie in the aligned cube `window`, in cells:
/// what `lookUp` returns for each, in one traversal. The words must have been checked.
void visitWindow(const WordReader &words, const Stratum &stratum, std::uint64_t offset, const Cube &window,
                 WindowVisit visit);

/// Visits the sub-volume at `offset` and its non-empty cells in Morton order, checking every word on the way.
void visitSubVolume(WordReader &words, const Stratum &stratum, std::uint64_t offset,
                    SubVolumeVisitor &visitor);

/// Moves all references of a block. `holdsVoxels`: the cells of the stratum are voxels, and stay. False if
/// one leads nowhere.
bool relocate(std::span<std::uint32_t> words, const Stratum &stratum, Block block, bool holdsVoxels,
              Relocation relocation);

} // namespace voxc
