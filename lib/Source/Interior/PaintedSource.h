// A source of which some cells have another word.
#pragma once

#include "Source/Interior/CellSet.h"
#include "voxc/Source/VoxelSource.h"

#include <memory>

namespace voxc {

/// The cells of `cells`, all of which lie in the extent, have the word `word`: 0 takes their voxels away.
std::unique_ptr<VoxelSource> paint(std::unique_ptr<VoxelSource> source, std::shared_ptr<const CellSet> cells,
                                   std::uint32_t word);

} // namespace voxc
