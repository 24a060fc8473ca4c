// A MagicaVoxel file as it is stored: models, nodes, layers and colours.
#pragma once

#include "Input/MagicaVoxel/Placement.h"

#include "voxc/Support/Error.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <vector>

namespace voxc {

/// Voxels of a model: four bytes each, x, y, z and the number of a colour.
struct VoxModel {
  Long3 size{};
  std::span<const std::byte> voxels;
};

/// A node of the scene graph: a transform has one child, a group any number, a shape a model.
struct VoxNode {
  enum class Kind { Transform, Group, Shape };

  Kind kind = Kind::Group;
  bool isHidden = false;
  Placement placement;                 ///< Of a transform.
  std::int32_t layer = -1;             ///< Of a transform.
  std::vector<std::uint32_t> children; ///< Of a transform or a group: numbers of nodes.
  std::uint32_t model = 0;             ///< Of a shape.
};

struct VoxFile {
  std::vector<VoxModel> models;
  std::map<std::uint32_t, VoxNode> nodes;
  std::set<std::int32_t> hiddenLayers;
  std::array<std::uint32_t, 256> colours; ///< By the number in a voxel; 0 is not a colour.
};

/// Reads a whole file in place. Of a node's or shape's frames the first in time is taken. Errors: not a
/// MagicaVoxel file; a chunk, a text or a list that reaches over its end; no model; a rotation that is none.
Expected<VoxFile> readVoxFile(std::span<const std::byte> bytes);

} // namespace voxc
