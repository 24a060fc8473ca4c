// Decoded voxels as runs of equal words in Morton order: building the runs and finding one.
#include "VoxelRuns.h"

#include <algorithm>
#include <bit>

namespace voxc {

namespace {

constexpr int kMaxIndexBits = 20;

/// Cells in a cube; 2^63 for the largest.
constexpr std::uint64_t cubeCells(int log2Side) { return std::uint64_t{1} << 3 * log2Side; }

} // namespace

int log2BoundingSide(Int3 extent) {
  auto longest = static_cast<unsigned>(std::max({extent.x, extent.y, extent.z, 1}));
  return std::bit_width(longest - 1);
}

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
  const int log2Side = log2BoundingSide(extent_);
  makeIndex(3 * log2Side);
  occupancy_ = OccupancyTree(changes(), log2Side);
}

/// The codes at which empty cells follow on others, or others on empty ones.
std::vector<std::uint64_t> VoxelRuns::changes() const {
  std::vector<std::uint64_t> changes;
  for (std::size_t run = 0; run < words_.size(); ++run)
    if ((words_[run] != 0) != (changes.size() % 2 == 1))
      changes.push_back(starts_[run]);
  return changes;
}

void VoxelRuns::makeIndex(int codeBits) {
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

std::uint32_t VoxelRuns::word(Int3 cell) const {
  const std::uint64_t code = mortonCode(cell);
  const std::size_t block = code >> indexShift_;
  const auto first = starts_.begin() + static_cast<std::ptrdiff_t>(firstRun_[block]);
  const auto last = starts_.begin() + static_cast<std::ptrdiff_t>(firstRun_[block + 1]) + 1;
  return words_[static_cast<std::size_t>(std::upper_bound(first, last, code) - starts_.begin()) - 1];
}

std::vector<Int3> VoxelRuns::sample(std::size_t count) const {
  std::vector<Int3> ends;
  // An odd step: runs that are empty and others take turns.
  const std::size_t step = 2 * words_.size() / std::max<std::size_t>(count, 1) | 1;
  for (std::size_t run = 0; run < words_.size(); run += step)
    for (const std::uint64_t code : {starts_[run], starts_[run + 1] - 1})
      if (words_[run] != 0 && ends.size() < count && contains(extent_, mortonCell(code)))
        ends.push_back(mortonCell(code));
  return ends;
}

std::optional<Cube> VoxelRuns::emptyAround(Int3 cell) const {
  const std::optional<int> log2Side = occupancy_.emptyAround(cell);
  if (!log2Side)
    return std::nullopt;
  const int mask = -1 << *log2Side;
  return Cube{{cell.x & mask, cell.y & mask, cell.z & mask}, *log2Side};
}

} // namespace voxc
