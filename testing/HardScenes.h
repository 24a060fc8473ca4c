// Scenes that are chosen to hurt: for tests of whole pipelines and for `voxc-hard-rays`.
#pragma once

#include "voxc/Source/VoxelSource.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace voxc::test {

/// A scene of a given extent; its voxels are made by arithmetic on integers, the same on every machine.
struct HardScene {
  std::string name;
  std::function<std::uint32_t(Int3)> voxel; ///< The word of a cell in the extent.
  std::function<bool(const Cube &)> empty;  ///< As `makeFunctionSource` takes it; it may be left out.
  Int3 extent;

  /// A new reader of the scene.
  std::unique_ptr<VoxelSource> source() const { return makeFunctionSource(extent, voxel, empty); }
};

/// All scenes, in an extent of at least one cell on each axis: empty and full ones, checkerboards, blocks,
/// dust of 1 % and of 50 %, single voxels in every corner, a layer, a slope and a shell one voxel thick, and
/// tunnels. They fill an extent of up to 64 cells on each axis; of a larger one they fill cubes of 32 cells
/// in its corners and in its middle alone, so that they are built fast in any format.
std::vector<HardScene> hardScenes(Int3 extent);

} // namespace voxc::test
