// Few colours for many: a histogram of 64 steps a channel, cut where it varies most.
#include "voxc/Source/Rounding.h"

#include "CubeTools.h"

#include <algorithm>
#include <bit>
#include <span>
#include <unordered_set>
#include <vector>

namespace voxc {
namespace {

constexpr int kStepBits = 6;
constexpr std::size_t kCells = std::size_t{1} << 3 * kStepBits;
constexpr std::size_t kMostRefined = 256;
constexpr int kRefinements = 8;
constexpr int kLog2Brick = 3;

std::size_t cellOf(std::uint32_t word) {
  const auto step = [word](int i) { return word >> (8 * i + 8 - kStepBits) & ((1u << kStepBits) - 1); };
  return step(0) | step(1) << kStepBits | step(2) << 2 * kStepBits;
}

/// The colours that fall into one cell, summed up.
struct Cell {
  std::array<std::uint64_t, 4> sum{};
  std::uint64_t voxels = 0;

  double mean(int i) const {
    return static_cast<double>(sum[static_cast<std::size_t>(i)]) / static_cast<double>(voxels);
  }
  void add(const Cell &other) {
    for (std::size_t i = 0; i < 4; ++i)
      sum[i] += other.sum[i];
    voxels += other.voxels;
  }
  std::uint32_t colour() const {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i)
      word |= static_cast<std::uint32_t>((sum[i] + voxels / 2) / voxels) << 8 * i;
    return word == 0 ? 1 : word; // The word 0 is no voxel.
  }
};

struct Histogram {
  std::vector<Cell> cells = std::vector<Cell>(kCells);
  bool hasFew = true; ///< No more different words than were asked for.
};

int log2Around(Int3 extent) {
  return std::bit_width(static_cast<unsigned>(std::max({extent.x, extent.y, extent.z, 1})) - 1);
}

Expected<Histogram> histogramOf(VoxelSource &source, std::size_t few, const Progress &progress) {
  Histogram histogram;
  std::unordered_set<std::uint32_t> words;
  std::uint32_t last = 0;
  const auto take = [&](std::uint32_t word) {
    Cell &cell = histogram.cells[cellOf(word)];
    for (std::size_t i = 0; i < 4; ++i)
      cell.sum[i] += word >> 8 * i & 255;
    ++cell.voxels;
    if (word != last && histogram.hasFew)
      histogram.hasFew = words.insert(word).second ? words.size() <= few : true;
    last = word;
  };
  std::vector<Cube> ahead = {{{}, log2Around(source.extent())}};
  std::array<std::uint32_t, 512> brick;
  while (!ahead.empty()) {
    if (progress.stopped())
      return Error::interrupted();
    const Cube cube = ahead.back();
    ahead.pop_back();
    if (isOutside(cube, source.extent()) || source.empty(cube))
      continue;
    if (cube.log2Side <= kLog2Brick) {
      VOXC_TRY(source.read(cube, brick.data()));
      for (std::uint64_t i = 0; i < cellCount(cube.log2Side); ++i)
        if (brick[i] != 0)
          take(brick[i]);
      continue;
    }
    const int log2Side = cube.log2Side - 1;
    for (int child = 8; child-- > 0;)
      ahead.push_back({cube.low + Int3{child & 1, child >> 1 & 1, child >> 2} * (1 << log2Side), log2Side});
  }
  return histogram;
}

/// Some of the cells with voxels, which one colour is to stand for.
struct Box {
  std::span<std::size_t> cells;
  double deviation = 0; ///< Sum of squared deviations from the mean, of the channel where it is greatest.
  int channel = 0;
  double mean = 0; ///< Of that channel.
};

Box boxOf(const std::vector<Cell> &histogram, std::span<std::size_t> cells) {
  Cell all;
  for (const std::size_t cell : cells)
    all.add(histogram[cell]);
  Box box{.cells = cells};
  for (int i = 0; i < 4 && cells.size() > 1; ++i) {
    double deviation = 0;
    for (const std::size_t cell : cells) {
      const double off = histogram[cell].mean(i) - all.mean(i);
      deviation += off * off * static_cast<double>(histogram[cell].voxels);
    }
    if (deviation > box.deviation)
      box = {cells, deviation, i, all.mean(i)};
  }
  return box;
}

/// Cuts what varies most at its mean until there are so many boxes, or none varies.
std::vector<Box> cut(const std::vector<Cell> &histogram, std::span<std::size_t> cells, std::size_t most) {
  const auto variesLess = [](const Box &a, const Box &b) { return a.deviation < b.deviation; };
  std::vector<Box> boxes = {boxOf(histogram, cells)};
  while (boxes.size() < most && boxes.front().deviation > 0) {
    std::ranges::pop_heap(boxes, variesLess);
    const Box box = boxes.back();
    boxes.pop_back();
    const auto above = std::ranges::stable_partition(
        box.cells, [&](std::size_t cell) { return histogram[cell].mean(box.channel) <= box.mean; });
    const std::size_t below = box.cells.size() - above.size();
    if (below == 0 || above.empty()) { // What deviates by rounding alone is one colour.
      boxes.push_back({.cells = box.cells});
      std::ranges::push_heap(boxes, variesLess);
      continue;
    }
    for (const auto half : {box.cells.first(below), box.cells.subspan(below)}) {
      boxes.push_back(boxOf(histogram, half));
      std::ranges::push_heap(boxes, variesLess);
    }
  }
  return boxes;
}

/// Lloyd's step: each cell goes to the nearest mean; the means of what came are the next. True if all stayed.
bool refine(const std::vector<Cell> &histogram, std::span<const std::size_t> cells, std::vector<Cell> &means,
            std::vector<std::uint32_t> &boxOfCell) {
  bool stayed = true;
  std::vector<Cell> next(means.size());
  for (const std::size_t cell : cells) {
    std::uint32_t nearest = boxOfCell[cell];
    double least = -1;
    for (std::uint32_t box = 0; box < means.size(); ++box) {
      double distance = 0;
      for (int i = 0; i < 4; ++i) {
        const double off = histogram[cell].mean(i) - means[box].mean(i);
        distance += off * off;
      }
      if (least < 0 || distance < least) {
        least = distance;
        nearest = box;
      }
    }
    stayed = stayed && nearest == boxOfCell[cell];
    boxOfCell[cell] = nearest;
    next[nearest].add(histogram[cell]);
  }
  for (std::size_t box = 0; box < means.size(); ++box)
    if (next[box].voxels > 0)
      means[box] = next[box];
  return stayed;
}

} // namespace

Expected<Rounding> reduceColours(VoxelSource &source, std::size_t most, const Progress &progress) {
  const auto found = VOXC_TRY(histogramOf(source, most, progress));
  if (found.hasFew)
    return Rounding();
  const std::vector<Cell> &histogram = found.cells;
  std::vector<std::size_t> cells;
  for (std::size_t cell = 0; cell < kCells; ++cell)
    if (histogram[cell].voxels > 0)
      cells.push_back(cell);
  const std::vector<Box> boxes = cut(histogram, cells, most);
  std::vector<std::uint32_t> boxOfCell(kCells);
  std::vector<Cell> means(boxes.size());
  for (std::uint32_t box = 0; box < boxes.size(); ++box)
    for (const std::size_t cell : boxes[box].cells) {
      boxOfCell[cell] = box;
      means[box].add(histogram[cell]);
    }
  for (int i = 0; i < kRefinements && means.size() <= kMostRefined; ++i)
    if (refine(histogram, cells, means, boxOfCell))
      break;
  auto colours = std::make_shared<std::vector<std::uint32_t>>(kCells);
  for (const std::size_t cell : cells)
    (*colours)[cell] = means[boxOfCell[cell]].colour();
  return Rounding([colours](std::uint32_t word) { return (*colours)[cellOf(word)]; });
}

} // namespace voxc
