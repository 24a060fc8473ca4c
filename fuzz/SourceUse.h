// Reading the voxels of whatever a reader took for sound.
#pragma once

#include "FuzzedFile.h"

#include "voxc/Input/Input.h"

#include <algorithm>
#include <array>

namespace voxc::fuzz {

/// Ends where the source fails.
inline void traversal(VoxelSource &source, const Cube &cube, int &bricksLeft) {
  if (bricksLeft <= 0 || source.empty(cube))
    return;
  if (cube.log2Side == 3) {
    std::array<std::uint32_t, 512> words;
    bricksLeft = source.read(cube, words.data()) ? bricksLeft - 1 : 0;
    return;
  }
  const int half = cube.log2Side - 1;
  for (std::uint64_t child = 0; child < 8; ++child)
    traversal(source, {cube.low + mortonCell(child) * (1 << half), half}, bricksLeft);
}

/// Reads some of the voxels. Formats hold little, so that a small file cannot stand for much honest work.
inline void readVoxels(const Expected<Input> &input) {
  if (!input)
    return;
  const Int3 extent = input->source->extent();
  int log2Side = 3;
  while (1 << log2Side < std::max({extent.x, extent.y, extent.z}))
    ++log2Side;
  int bricksLeft = 2000;
  traversal(*input->source, {{}, log2Side}, bricksLeft);
}

inline InputOptions fuzzedOptions() {
  InputOptions options;
  options.formatExtent = {1 << 12, 1 << 12, 1 << 12};
  // Small, so that the scratch file is used too.
  options.memory = WorkingMemory::create(1 << 22);
  return options;
}

} // namespace voxc::fuzz
