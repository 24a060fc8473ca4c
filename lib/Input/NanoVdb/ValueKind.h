// The types of values that NanoVDB grids are read of, and how they lie in roots and leaves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace voxc {

/// How the values of a type become voxels.
enum class ValueMeaning : std::uint8_t {
  Sample, ///< A number, active or not.
  Colour, ///< The word of a voxel, where it is active.
  Flag    ///< A voxel where it is not 0.
};

/// One type of values. All numbers are read as float64.
struct ValueKind {
  std::uint32_t type;
  const char *name;
  ValueMeaning meaning;
  std::uint32_t rootBytes;
  std::uint32_t background; ///< Where it stands in the root.
  std::uint32_t tileValue;  ///< Where a value stands in a tile of the root.
  std::uint32_t leafBytes;
  /// A value of a root tile, of the table of a node, or the background.
  double (*read)(const std::byte *at);
  /// The value of a cell of a leaf.
  double (*readCell)(const std::byte *leaf, std::uint32_t cell);
  bool isWhole = false; ///< Its numbers are whole.
};

/// The kind of a type; null if it is not read.
const ValueKind *findValueKind(std::uint32_t type);

/// What the values of a type are called, also of those that are not read.
std::string nameOfType(std::uint32_t type);

/// Whether cell `cell` of a leaf is active.
bool isActiveInLeaf(const std::byte *leaf, std::uint32_t cell);

} // namespace voxc
