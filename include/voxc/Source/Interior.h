// What of a scene can be seen: voxels without those that are hidden, with what they enclose filled, or moved
// so that there is no empty border.
#pragma once

#include "voxc/Source/VoxelSource.h"
#include "voxc/Support/Progress.h"
#include "voxc/Support/WorkingMemory.h"

#include <cstdint>
#include <memory>

namespace voxc {

/// What becomes of the inside of things.
enum class Interior : std::uint8_t {
  Keep, ///< Nothing.
  Drop, ///< Voxels that no ray from outside comes to are left out.
  Fill, ///< What voxels enclose, or a closed mesh, becomes voxels.
};

/// A source that was changed, and how many of its voxels were left out or added.
struct ChangedSource {
  std::unique_ptr<VoxelSource> source;
  std::uint64_t voxels = 0;
};

/// With what means the inside is found. None of them changes a voxel.
struct InteriorOptions {
  std::shared_ptr<WorkingMemory> memory = WorkingMemory::createDefault();
  unsigned threads = 1; ///< That read the source, if it has several readers; 0: as many as the machine has.
  Progress progress;
};

/// The voxels of `source` but those that are hidden: no ray that begins outside the voxels' box, or in an
/// empty cell that such a ray comes to, changes its hit by a bit. Other rays do. Exactly: empty cells are
/// flooded from outside along the steps that a ray can make by the definition of the hit, which are steps up,
/// or down, on one, two or three axes at once; a voxel in which no step from a flooded cell ends is hidden.
/// Reads the source once, before it returns; memory follows the surface. Errors: that of a source that fails,
/// interrupted, no memory or scratch file.
Expected<ChangedSource> dropInterior(std::unique_ptr<VoxelSource> source,
                                     const InteriorOptions &options = {});

/// The voxels of `source`, and one with the word `word` (not 0) in each empty cell from which no path over
/// faces of empty cells leads out of it. Errors: as `dropInterior`.
Expected<ChangedSource> fillInterior(std::unique_ptr<VoxelSource> source, std::uint32_t word,
                                     const InteriorOptions &options = {});

} // namespace voxc
