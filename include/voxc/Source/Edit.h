// Edits of a finished volume's voxels, as a source: boxes that are filled or cleared, and volumes that are
// pasted.
#pragma once

#include "voxc/Source/VoxelSource.h"
#include "voxc/Volume/Volume.h"

#include <memory>
#include <span>
#include <vector>

namespace voxc {

/// One edit: voxels [low, low + size) are changed.
struct VoxelEdit {
  Int3 low;
  Int3 size;
  /// What they become: 0 clears them. Of a paste it does not count.
  std::uint32_t word = 0;
  /// Null, or a volume whose voxel v is put at low + v where it is not empty; `size` is its extent.
  std::shared_ptr<const Volume> pasted;

  /// Whether it may change a voxel of the cube.
  bool touches(const Cube &cube) const;
};

/// Error (`Input`): an edit that reaches out of the extent, naming its place among them.
Expected<void> checkEdits(std::span<const VoxelEdit> edits, Int3 extent);

/// The voxels of `volume` after the edits, one after the other; the extent stays. Error: as
/// `checkEdits`.
Expected<std::unique_ptr<VoxelSource>> makeEditedSource(std::shared_ptr<const Volume> volume,
                                                        std::vector<VoxelEdit> edits);

} // namespace voxc
