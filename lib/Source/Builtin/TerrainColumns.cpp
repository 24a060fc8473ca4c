// Filling blocks of terrain columns from the heights of the ground.
#include "Source/Builtin/TerrainColumns.h"

#include <algorithm>

namespace voxc {

const TerrainColumn &TerrainColumns::at(int x, int z) {
  const int blockX = x >> kLog2Block;
  const int blockZ = z >> kLog2Block;
  Block &block = blocks_[static_cast<std::size_t>(blockX % 64 + 64 * (blockZ % 64))];
  if (block.x != blockX || block.z != blockZ) {
    block.x = blockX;
    block.z = blockZ;
    fill(block);
  }
  return block.columns[static_cast<std::size_t>(x % kBlock + kBlock * (z % kBlock))];
}

void TerrainColumns::fill(Block &block) const {
  // One more on each side: a column reaches down to its lowest neighbour.
  constexpr int kWidth = kBlock + 2;
  std::array<int, kWidth * kWidth> grounds;
  const int lowX = block.x * kBlock;
  const int lowZ = block.z * kBlock;
  for (int z = 0; z < kWidth; ++z)
    for (int x = 0; x < kWidth; ++x)
      grounds[static_cast<std::size_t>(x + kWidth * z)] = shape_.ground(lowX + x - 1, lowZ + z - 1);

  const int last = shape_.side() - 1;
  const int water = shape_.waterLevel();
  for (int z = 0; z < kBlock; ++z)
    for (int x = 0; x < kBlock; ++x) {
      const int *centre = &grounds[static_cast<std::size_t>(x + 1 + kWidth * (z + 1))];
      const int lowest = std::min({centre[-1], centre[1], centre[-kWidth], centre[kWidth]});
      const int surface = std::max(*centre, water);
      const bool atWall = lowX + x == 0 || lowZ + z == 0 || lowX + x == last || lowZ + z == last;
      block.columns[static_cast<std::size_t>(x + kBlock * z)] = {
          *centre, surface, atWall ? 0 : std::min(surface, std::max(lowest, water) + 1), *centre - lowest};
    }
}

} // namespace voxc
