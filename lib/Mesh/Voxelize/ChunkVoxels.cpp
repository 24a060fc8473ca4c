// Bricks of a chunk: made, asked and read.
#include "Mesh/Voxelize/ChunkVoxels.h"

#include <algorithm>

namespace voxc {

ChunkVoxels::ChunkVoxels(int log2Side) : table_(std::size_t{1} << 3 * (log2Side - kLog2Brick)) {
  for (std::uint32_t i = 0; i < spread_.size(); ++i)
    spread_[i] = static_cast<std::uint32_t>(spreadBits(i));
}

void ChunkVoxels::clear(Int3 low) {
  low_ = low;
  if (used_ != 0)
    std::fill(table_.begin(), table_.end(), nullptr);
  used_ = 0;
}

ChunkVoxels::Brick *ChunkVoxels::addBrick() {
  if (used_ == bricks_.size())
    bricks_.push_back(std::make_unique<Brick>());
  Brick *brick = bricks_[used_++].get();
  brick->words.fill(0);
  brick->distances.fill(~std::uint32_t{0});
  brick->hasMeans = false;
  return brick;
}

void ChunkVoxels::addMeans(Brick &brick) {
  if (!brick.means)
    brick.means = std::make_unique<std::array<VoxelMean, kBrickCells>>();
  brick.means->fill({});
  brick.hasMeans = true;
}

bool ChunkVoxels::empty(const Cube &cube) const {
  const std::uint32_t code = codeOf(cube.low);
  const auto first = table_.begin() + (code >> 3 * kLog2Brick);
  if (cube.log2Side >= kLog2Brick)
    return std::all_of(first, first + (1 << 3 * (cube.log2Side - kLog2Brick)),
                       [](const Brick *brick) { return !brick; });
  if (!*first)
    return true;
  const std::uint32_t *words = (*first)->words.data() + (code & (kBrickCells - 1));
  return std::all_of(words, words + (1 << 3 * cube.log2Side), [](std::uint32_t word) { return word == 0; });
}

void ChunkVoxels::read(const Cube &cube, std::uint32_t *words) const {
  const std::uint32_t code = codeOf(cube.low);
  const auto count = std::uint32_t{1} << 3 * cube.log2Side;
  if (const Brick *brick = table_[code >> 3 * kLog2Brick])
    std::copy_n(brick->words.data() + (code & (kBrickCells - 1)), count, words);
  else
    std::fill_n(words, count, 0u);
}

} // namespace voxc
