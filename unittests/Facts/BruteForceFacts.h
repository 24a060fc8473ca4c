// The facts of voxels by their definitions, from a list of all voxels: slow, simple, and exact.
#pragma once

#include "voxc/Facts/Facts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace voxc::test {

/// Voxels by their Morton code.
using Voxels = std::map<std::uint64_t, std::uint32_t>;

inline Voxels voxelsOf(Int3 extent, const std::function<std::uint32_t(Int3)> &voxel) {
  Voxels voxels;
  for (Int3 cell; cell.z < extent.z; ++cell.z)
    for (cell.y = 0; cell.y < extent.y; ++cell.y)
      for (cell.x = 0; cell.x < extent.x; ++cell.x)
        if (const std::uint32_t word = voxel(cell))
          voxels[mortonCode(cell)] = word;
  return voxels;
}

class BruteForceFacts {
public:
  BruteForceFacts(Int3 extent, Voxels voxels) : extent_(extent), voxels_(std::move(voxels)) {}

  Facts measure() const {
    Facts facts;
    facts.extent = extent_;
    while (1 << facts.log2Extent < std::max({extent_.x, extent_.y, extent_.z}))
      ++facts.log2Extent;
    facts.voxels = voxels_.size();
    findPlaces(facts);
    for (int height = 0; height <= facts.log2Extent; ++height)
      facts.heights.push_back(height == 0 ? ofVoxels() : ofCubes(height));
    facts.colours = colours();
    for (int height = 1; height <= std::min(6, facts.log2Extent); ++height)
      facts.repetition.push_back(repetition(height));
    return facts;
  }

private:
  /// A voxel in its block: its place there, and its word.
  using Block = std::vector<std::pair<Int3, std::uint32_t>>;

  /// The blocks of a height that are not empty.
  std::vector<Block> blocks(int height) const {
    std::map<std::uint64_t, Block> blocks;
    for (const auto &[code, word] : voxels_) {
      const std::uint64_t block = code >> 3 * height;
      blocks[block].push_back({mortonCell(code - (block << 3 * height)), word});
    }
    std::vector<Block> list;
    for (auto &[code, block] : blocks)
      list.push_back(std::move(block));
    return list;
  }

  void findPlaces(Facts &facts) const {
    facts.boxLow = voxels_.empty() ? Int3{} : extent_;
    facts.regions.log2Side = std::max(0, facts.log2Extent - 2);
    for (const auto &[code, word] : voxels_) {
      const Int3 cell = mortonCell(code);
      bool isInside = true;
      for (int axis = 0; axis < 3; ++axis) {
        facts.boxLow[axis] = std::min(facts.boxLow[axis], cell[axis]);
        facts.boxHigh[axis] = std::max(facts.boxHigh[axis], cell[axis] + 1);
        for (const int step : {-1, 1}) {
          Int3 near = cell;
          near[axis] += step;
          isInside = isInside && contains(extent_, near) && voxels_.contains(mortonCode(near));
        }
      }
      facts.interior += isInside;
      const Int3 region = cell >> facts.regions.log2Side;
      ++facts.regions.voxels[static_cast<std::size_t>(region.x + 4 * region.y + 16 * region.z)];
    }
  }

  HeightFacts ofVoxels() const {
    const std::uint64_t count = voxels_.size();
    return {count, count, count, count};
  }

  HeightFacts ofCubes(int height) const {
    HeightFacts facts;
    for (const Block &block : blocks(height)) {
      const bool isFull = block.size() == std::size_t{1} << 3 * height;
      const bool isOne = different(block) == 1;
      ++facts.occupied;
      facts.full += isFull;
      facts.oneColour += isOne;
      facts.uniform += isFull && isOne;
    }
    return facts;
  }

  static std::size_t different(const Block &block) {
    std::set<std::uint32_t> words;
    for (const auto &[cell, word] : block)
      words.insert(word);
    return words.size();
  }

  static double meanDifferent(const std::vector<Block> &blocks) {
    double sum = 0;
    for (const Block &block : blocks)
      sum += static_cast<double>(different(block));
    return blocks.empty() ? 0 : sum / static_cast<double>(blocks.size());
  }

  ColourFacts colours() const {
    ColourFacts facts;
    if (voxels_.empty())
      return facts;
    std::map<std::uint32_t, double> counts;
    std::set<std::uint32_t> rgb, alphas;
    std::vector<Block> runs;
    std::uint32_t before = 0;
    for (const auto &[code, word] : voxels_) {
      if (runs.empty() || runs.back().size() == 256)
        runs.emplace_back();
      runs.back().push_back({mortonCell(code), word});
      ++counts[word];
      rgb.insert(word & 0xffffff);
      alphas.insert(word >> 24);
      facts.opaque += word >> 24 == 255;
      facts.transparent += word >> 24 == 0;
      facts.repeats += word == before;
      before = word;
    }
    const auto all = static_cast<double>(voxels_.size());
    for (const auto &[word, count] : counts)
      facts.entropy -= count / all * std::log2(count / all);
    facts.words = {counts.size(), true};
    facts.rgb = {rgb.size(), true};
    facts.alphas = static_cast<int>(alphas.size());
    facts.perBlock4 = meanDifferent(blocks(2));
    facts.perBlock8 = meanDifferent(blocks(3));
    facts.perRun256 = meanDifferent(runs);
    for (std::size_t i = 0; i < 4; ++i)
      facts.channels[i] = channel(8 * static_cast<int>(i));
    return facts;
  }

  ChannelFacts channel(int shift) const {
    ChannelFacts facts{255, 0, 0};
    for (const auto &[code, word] : voxels_) {
      const int value = static_cast<int>(word >> shift & 255);
      facts.least = std::min(facts.least, value);
      facts.greatest = std::max(facts.greatest, value);
      facts.mean += value / static_cast<double>(voxels_.size());
    }
    return facts;
  }

  /// The places of a block's voxels, mirrored in the axes whose bit is set.
  static std::vector<std::uint64_t> shape(const Block &block, int height, int axes) {
    std::vector<std::uint64_t> codes;
    for (auto [cell, word] : block) {
      for (int axis = 0; axis < 3; ++axis)
        if (axes >> axis & 1)
          cell[axis] = (1 << height) - 1 - cell[axis];
      codes.push_back(mortonCode(cell));
    }
    std::ranges::sort(codes);
    return codes;
  }

  RepetitionFacts repetition(int height) const {
    std::set<std::vector<std::uint64_t>> shapes, mirrored;
    std::set<std::vector<std::pair<std::uint64_t, std::uint32_t>>> coloured;
    const std::vector<Block> all = blocks(height);
    for (const Block &block : all) {
      shapes.insert(shape(block, height, 0));
      std::vector<std::uint64_t> least = shape(block, height, 0);
      for (int axes = 1; axes < 8; ++axes)
        least = std::min(least, shape(block, height, axes));
      mirrored.insert(least);
      std::vector<std::pair<std::uint64_t, std::uint32_t>> content;
      for (const auto &[cell, word] : block)
        content.push_back({mortonCode(cell), word});
      coloured.insert(content);
    }
    return {height, all.size(), {shapes.size(), true}, {mirrored.size(), true}, {coloured.size(), true}};
  }

  Int3 extent_;
  Voxels voxels_;
};

} // namespace voxc::test
