// A Menger sponge of as many generations as fit, stretched to fill its cube.
#include "Source/Builtin/Scenes.h"

#include <algorithm>

namespace voxc {

namespace {

class Menger {
public:
  explicit Menger(int side) : side_(side) {
    while (std::int64_t{3} * cells_ <= side)
      cells_ *= 3;
  }

  std::uint32_t operator()(Int3 cell) const { return empty({cell, 0}) ? 0 : rgba(206, 170, 96); }

  /// True if one hole of some generation holds the cube.
  bool empty(const Cube &cube) const {
    std::int64_t low[3];
    std::int64_t high[3];
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = spongeCell(cube.low[axis]);
      high[axis] = spongeCell(std::min<std::int64_t>(cube.low[axis] + cube.side(), side_) - 1);
    }
    // Within one generation, a hole is where two digits of base 3 or more are in the middle.
    for (std::int64_t unit = cells_ / 3; unit > 0; unit /= 3) {
      int middles = 0;
      for (int axis = 0; axis < 3; ++axis)
        middles += low[axis] / unit == high[axis] / unit && low[axis] / unit % 3 == 1;
      if (middles >= 2)
        return true;
    }
    return false;
  }

private:
  std::int64_t spongeCell(std::int64_t coordinate) const { return coordinate * cells_ / side_; }

  int side_;
  std::int64_t cells_ = 1; ///< Of the sponge, on an axis: a power of three.
};

} // namespace

std::unique_ptr<VoxelSource> makeMenger(int side) {
  const Menger menger(side);
  return makeFunctionSource({side, side, side}, menger,
                            [menger](const Cube &cube) { return menger.empty(cube); });
}

} // namespace voxc
