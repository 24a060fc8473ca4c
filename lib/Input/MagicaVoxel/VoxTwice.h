// Voxels that a model has more than once.
#pragma once

#include "Input/MagicaVoxel/VoxScene.h"

#include "voxc/Support/WorkingMemory.h"

#include <memory>
#include <string>
#include <vector>

namespace voxc {

/// A sentence about voxels that a model has before in another colour, if there are any. All voxels lie in
/// their models. Errors: as `WorkingMemory::allocate`.
Expected<void> warnOfVoxelsTwice(const VoxScene &scene, const std::shared_ptr<WorkingMemory> &memory,
                                 std::vector<std::string> &warnings);

} // namespace voxc
