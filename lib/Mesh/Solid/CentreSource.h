// A solid with the colours of its surface.
#pragma once

#include "Source/Interior/CellSet.h"
#include "voxc/Source/VoxelSource.h"

#include <array>
#include <memory>

namespace voxc {

/// The cells of two sets, all of which lie in the extent: with the word of `surface`, or where that has none
/// with `word`. No other cell is a voxel.
std::unique_ptr<VoxelSource> makeCentreSource(std::unique_ptr<VoxelSource> surface,
                                              std::array<std::shared_ptr<const CellSet>, 2> cells,
                                              std::uint32_t word);

} // namespace voxc
