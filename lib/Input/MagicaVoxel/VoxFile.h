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
#include <string>
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

/// How light meets a material, other than by its colour alone.
enum class VoxLook : std::uint8_t { Diffuse, Metal, Glass, Emission, Cloud };

struct VoxFile {
  std::vector<VoxModel> models;
  std::map<std::uint32_t, VoxNode> nodes;
  std::set<std::int32_t> hiddenLayers;
  std::array<std::uint32_t, 256> colours; ///< By the number in a voxel; 0 is not a colour.
  std::array<VoxLook, 256> looks{};       ///< The same of materials,
  std::array<float, 256> roughness;       ///< how rough they are, 0 to 1; 1 where nothing is said,
  std::array<float, 256> metallic{};      ///< how metallic, if they are metals,
  std::array<float, 256> clear{};         ///< how clear, if they are glass,
  std::array<float, 256> light{}; ///< and how many times as bright as their colour, if they give off light.
  std::set<std::string> unknown;  ///< Names of chunks, the first few.
  std::set<std::string> unused;   ///< Names of chunks and attributes that change no voxel, the first few.
  std::uint64_t bytesBehind = 0;  ///< The voxels that models say they have.
  std::int32_t frames = 1;        ///< Of the scene graph: one more than the time of its last key.
};

/// Reads a whole file in place. Nodes and shapes are as `keyAt` has them at the time `frame`, from 0 on.
/// Errors: not a MagicaVoxel file; a chunk, a text or a list that reaches over its end; no model; a time, a
/// place or a rotation that is none.
Expected<VoxFile> readVoxFile(std::span<const std::byte> bytes, std::int32_t frame = 0);

} // namespace voxc
