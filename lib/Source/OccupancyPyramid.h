// Which aligned cubes of a dense grid hold anything, at every size: what makes `empty` cheap.
#pragma once

#include "voxc/Support/Geometry.h"

#include <cstdint>
#include <vector>

namespace voxc {

/// One bit for each aligned cube of 8, 16, 32, ... cells a side that a grid reaches into.
class OccupancyPyramid {
public:
  /// The smallest cubes are 2^kLog2Brick cells a side.
  static constexpr int kLog2Brick = 3;

  explicit OccupancyPyramid(Int3 extent);

  /// Marks the cubes around `cell`, which lies in the extent.
  void mark(Int3 cell);
  /// True if no cell of `cube`, whose side is at least 2^kLog2Brick, was marked.
  bool empty(const Cube &cube) const;

private:
  struct Layer {
    Int3 size;
    std::vector<bool> marked;

    std::size_t index(Int3 cube) const;
  };

  std::vector<Layer> layers_;
};

} // namespace voxc
