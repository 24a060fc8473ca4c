// Cells of bricks as a list, and the set that they make.
#pragma once

#include "Source/BrickBits.h"
#include "Source/Interior/CellSet.h"

#include <memory>
#include <span>

namespace voxc {

/// Some of the cells of a brick of 8^3.
struct BrickCells {
  Int3 low;
  Slices cells;
};

/// The set of the cells of bricks that come in Morton order, each once, and lie in [0, extent). Error: no
/// memory.
Expected<std::shared_ptr<const CellSet>> setOf(std::span<const BrickCells> bricks, Int3 extent,
                                               const std::shared_ptr<WorkingMemory> &memory);

} // namespace voxc
