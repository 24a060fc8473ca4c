// The scene of a MagicaVoxel file: which of its models are to be seen, and where.
#pragma once

#include "Input/MagicaVoxel/VoxFile.h"

#include <optional>
#include <string>
#include <vector>

namespace voxc {

/// A model at a place.
struct VoxInstance {
  const VoxModel *model = nullptr;
  Placement placement; ///< From the model's cells to those of the scene.
};

/// In MagicaVoxel's axes, whose up is +z.
struct VoxScene {
  std::vector<VoxInstance> instances; ///< In the order of the scene graph.
  Long3 low{};                        ///< The box of all instances.
  Long3 size{};
  std::int32_t frames = 1; ///< Of the animation.
  std::vector<std::string> warnings;
};

/// Follows the scene graph from its root; hidden nodes and layers are left out. Without a graph a model is a
/// frame, and that of number `frame`, from 0 on, is the scene; with one, `file` was read for that frame.
/// Without a `frame` the first is taken, and a warning says that there are more. `file` must outlive the
/// scene. Errors: no such frame, a node or model that is not there, a node that stands below itself, a graph
/// that stands for more than 2^20 nodes, a scene of more than 2^21 cells an axis.
Expected<VoxScene> makeVoxScene(const VoxFile &file, std::optional<std::int32_t> frame = {});

} // namespace voxc
