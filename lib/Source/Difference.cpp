// What is different between two sources: both are asked for the same cubes, in Morton order.
#include "CubeTools.h"

#include "voxc/Source/VoxelChange.h"

#include <algorithm>
#include <array>
#include <bit>

namespace voxc {
namespace {

constexpr int kLog2Brick = 3;
constexpr std::size_t kMostVoxels = std::size_t{1} << 30;

class Comparison {
public:
  Comparison(VoxelSource &before, VoxelSource &after)
      : before_(before), after_(after), extentBefore_(before.extent()), extentAfter_(after.extent()) {}

  Expected<void> cube(const Cube &cube) {
    if (isEmpty(before_, extentBefore_, cube) && isEmpty(after_, extentAfter_, cube))
      return {};
    if (cube.log2Side <= kLog2Brick)
      return brick(cube);
    for (std::uint64_t child = 0; child < 8; ++child) {
      const int log2Side = cube.log2Side - 1;
      const Int3 low = cube.low + mortonCell(child << 3 * log2Side);
      VOXC_TRY(this->cube({low, log2Side}));
    }
    return {};
  }

  std::vector<VoxelWord> takeVoxels() { return std::move(voxels_); }

private:
  using Brick = std::array<std::uint32_t, std::size_t{1} << 3 * kLog2Brick>;

  static bool isEmpty(VoxelSource &source, Int3 extent, const Cube &cube) {
    return isOutside(cube, extent) || source.empty(cube);
  }

  static Expected<void> read(VoxelSource &source, Int3 extent, const Cube &cube, Brick &words) {
    words.fill(0);
    return isEmpty(source, extent, cube) ? Expected<void>() : source.read(cube, words.data());
  }

  Expected<void> brick(const Cube &cube) {
    VOXC_TRY(read(before_, extentBefore_, cube, old_));
    VOXC_TRY(read(after_, extentAfter_, cube, new_));
    forEachCell(cube, [&](std::uint64_t index, Int3 cell) {
      if (old_[index] != new_[index])
        voxels_.push_back({cell, new_[index]});
    });
    if (voxels_.size() > kMostVoxels)
      return Error::input("more than 2^30 voxels differ");
    return {};
  }

  VoxelSource &before_, &after_;
  Int3 extentBefore_, extentAfter_;
  Brick old_, new_;
  std::vector<VoxelWord> voxels_;
};

} // namespace

Expected<std::vector<VoxelWord>> differenceOf(VoxelSource &before, VoxelSource &after) {
  const Int3 a = before.extent(), b = after.extent();
  const int longestSide = std::max({a.x, a.y, a.z, b.x, b.y, b.z, 1 << kLog2Brick});
  const int log2Side = std::bit_width(static_cast<unsigned>(longestSide) - 1);
  Comparison comparison(before, after);
  VOXC_TRY(comparison.cube({{0, 0, 0}, log2Side}));
  return comparison.takeVoxels();
}

} // namespace voxc
