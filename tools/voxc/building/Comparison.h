// Comparing two voxel sources voxel by voxel.
#pragma once

#include "voxc/Source/VoxelSource.h"
#include "voxc/Support/Progress.h"

#include <cstdint>
#include <optional>

namespace voxc::tool {

/// How the voxels of a volume differ from those of its input.
struct VoxelDifferences {
  std::uint64_t equal = 0;   ///< Non-empty in both, with the same word.
  std::uint64_t missing = 0; ///< In the input alone.
  std::uint64_t surplus = 0; ///< In the volume alone.
  std::uint64_t changed = 0; ///< Another word.
  std::optional<Int3> first; ///< The first that differs, in Morton order.

  bool none() const { return missing == 0 && surplus == 0 && changed == 0; }
  /// Adds what was found in other voxels.
  void add(const VoxelDifferences &other);
};

/// The voxels whose Morton codes lie in [begin, end), which are those of aligned cubes of 8^3 or larger.
struct VoxelRange {
  std::uint64_t begin = 0;
  std::uint64_t end = std::uint64_t{1} << 3 * kMaxLog2Extent;
};

/// Reads both sources to the end of the range. Errors: that of a source that fails, or `Interrupted`.
Expected<VoxelDifferences> compareVoxels(VoxelSource &volume, VoxelSource &input, const Progress &progress,
                                         const VoxelRange &range = {});

} // namespace voxc::tool
