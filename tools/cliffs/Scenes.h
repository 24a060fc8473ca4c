// The scenes of situations, at any extent.
#pragma once

#include "voxc/Source/VoxelSource.h"
#include "voxc/Support/Error.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace voxc::cliffs {

/// The names of all scenes of an extent: those that hurt (testing/HardScenes.h), and the built-in ones where
/// it is a cube that is not too large for them.
std::vector<std::string> sceneNames(Int3 extent);

/// A reader of one of them. Error: there is no such scene.
Expected<std::unique_ptr<VoxelSource>> openScene(std::string_view name, Int3 extent);

} // namespace voxc::cliffs
