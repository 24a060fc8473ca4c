// Reading a volume's voxels back: one at a time, or all of them with their numbers.
#pragma once

#include "voxc/Support/FunctionRef.h"
#include "voxc/Volume/Volume.h"

#include <cstdint>
#include <functional>

namespace voxc {

/// Whether the voxel is there, a value of 0 or not, the side of the aligned cube around it that is alike, and
/// its rank in layouts that count voxels. Outside of the layout there is none.
Lookup lookUpShape(const WordReader &words, const Layout &layout, Int3 voxel);

/// Receives a uniform cube of voxels, numbered in Morton order from `number` on: by rank where levels count
/// voxels, else as they are found. False ends the decoding.
using NumberedVisit = std::function<bool(const Cube &cube, std::uint32_t word, std::uint64_t number)>;

/// As `decode`, with numbers; all of them are below `info().voxels`.
Expected<void> decodeNumbered(const Volume &volume, const NumberedVisit &visit, const Progress &progress);

/// Receives `count` voxels of a cube that are there, in Morton order from place `first` of it on: their value
/// in the last level, and the rank of the first.
using CubeVisit =
    FunctionRef<void(std::uint64_t first, std::uint64_t count, std::uint32_t value, std::uint64_t rank)>;

/// Visits the voxels of the aligned `cube` in one traversal: what `lookUpShape` tells of each.
void visitCube(const WordReader &words, const Layout &layout, const Cube &cube, CubeVisit visit);

/// Writes the words of all voxels of the aligned `cube` in Morton order, 8^log2Side of them: what
/// `Volume::lookup` tells of each.
void readCube(const Volume &volume, const Cube &cube, std::uint32_t *words);

} // namespace voxc
