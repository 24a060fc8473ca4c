// Decoded voxels as runs of equal words in Morton order: building the runs and finding one.
#include "VoxelRuns.h"

#include <algorithm>
#include <bit>

namespace voxc {

namespace {

constexpr int kMaxIndexBits = 20;

/// Cells in a cube; 2^63 for the largest.
constexpr std::uint64_t cubeCells(int log2Side) { return std::uint64_t{1} << 3 * log2Side; }

/// log2 of the side of the smallest aligned cube that holds an extent.
int log2BoundingSide(Int3 extent) {
  auto longest = static_cast<unsigned>(std::max({extent.x, extent.y, extent.z, 1}));
  return std::bit_width(longest - 1);
}

} // namespace

void VoxelRuns::startRun(std::uint64_t code, std::uint32_t word) {
  if (!words_.empty() && words_.back() == word)
    return;
  starts_.push_back(code);
  words_.push_back(word);
}

void VoxelRuns::add(const Cube &cube, std::uint32_t word) {
  const std::uint64_t code = mortonCode(cube.low);
  if (code > end_)
    startRun(end_, 0);
  startRun(code, word);
  end_ = code + cubeCells(cube.log2Side);
}

void VoxelRuns::finish() {
  startRun(end_, 0);
  starts_.push_back(cubeCells(kMaxLog2Extent));

  const int codeBits = 3 * log2BoundingSide(extent_);
  indexShift_ = std::max(0, codeBits - kMaxIndexBits);
  const std::size_t blocks = std::size_t{1} << (codeBits - indexShift_);
  firstRun_.resize(blocks + 1, words_.size() - 1);
  std::size_t run = 0;
  for (std::size_t block = 0; block < blocks; ++block) {
    while (starts_[run + 1] <= std::uint64_t{block} << indexShift_)
      ++run;
    firstRun_[block] = run;
  }
}

std::size_t VoxelRuns::runOf(std::uint64_t code) const {
  const std::size_t block = code >> indexShift_;
  const auto first = starts_.begin() + static_cast<std::ptrdiff_t>(firstRun_[block]);
  const auto last = starts_.begin() + static_cast<std::ptrdiff_t>(firstRun_[block + 1]) + 1;
  return static_cast<std::size_t>(std::upper_bound(first, last, code) - starts_.begin()) - 1;
}

UniformCube VoxelRuns::at(Int3 cell) const {
  const std::uint64_t code = mortonCode(cell);
  const std::size_t run = runOf(code);
  int log2Side = 0;
  while (log2Side < kMaxLog2Extent) {
    const std::uint64_t cells = cubeCells(log2Side + 1);
    const std::uint64_t low = code & ~(cells - 1);
    if (low < starts_[run] || low + cells > starts_[run + 1])
      break;
    ++log2Side;
  }
  return {{mortonCell(code & ~(cubeCells(log2Side) - 1)), log2Side}, words_[run]};
}

} // namespace voxc
