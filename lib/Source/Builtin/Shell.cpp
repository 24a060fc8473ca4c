// A hollow sphere that touches the six faces of its cube, one voxel thick.
#include "Source/Builtin/Scenes.h"

#include <algorithm>
#include <cstdlib>

namespace voxc {

namespace {

/// Lengths are counted in half voxels from the sphere's centre, where every voxel's centre is a whole number.
class Shell {
public:
  explicit Shell(int side) : side_(side) {}

  /// A voxel in the ball with a neighbour outside it.
  std::uint32_t operator()(Int3 cell) const {
    const std::int64_t x = std::abs(fromCentre(cell.x));
    const std::int64_t y = std::abs(fromCentre(cell.y));
    const std::int64_t z = std::abs(fromCentre(cell.z));
    if (!isInside(x, y, z) || (isInside(x + 2, y, z) && isInside(x, y + 2, z) && isInside(x, y, z + 2)))
      return 0;
    return rgba(channel(cell.x), channel(cell.y), channel(cell.z));
  }

  bool empty(const Cube &cube) const {
    std::int64_t nearest[3];
    std::int64_t farthest[3];
    for (int axis = 0; axis < 3; ++axis) {
      const std::int64_t low = fromCentre(cube.low[axis]);
      const std::int64_t high = fromCentre(cube.low[axis] + cube.side() - 1);
      nearest[axis] = std::max<std::int64_t>({low, -high, 0});
      farthest[axis] = std::max(std::abs(low), std::abs(high)) + 2;
    }
    return !isInside(nearest[0], nearest[1], nearest[2]) || isInside(farthest[0], farthest[1], farthest[2]);
  }

private:
  std::int64_t fromCentre(std::int64_t coordinate) const { return 2 * coordinate + 1 - side_; }

  bool isInside(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return x * x + y * y + z * z <= std::int64_t{side_} * side_;
  }

  /// The position along an axis as a colour channel, in 16 steps: smooth to look at, few different words.
  std::uint32_t channel(std::int32_t coordinate) const {
    return static_cast<std::uint32_t>(std::int64_t{16} * coordinate / side_) * 12 + 64;
  }

  int side_;
};

} // namespace

std::unique_ptr<VoxelSource> makeShell(int side) {
  const Shell shell(side);
  return makeFunctionSource({side, side, side}, shell,
                            [shell](const Cube &cube) { return shell.empty(cube); });
}

} // namespace voxc
