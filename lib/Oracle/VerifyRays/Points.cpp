// Points, directions and lines that rays are made of.
#include "Points.h"

#include <cstddef>

namespace voxc::oracle {

Ray backedOff(const Point &point, const Point &direction, float steps) {
  Ray ray{};
  for (int axis = 0; axis < 3; ++axis) {
    ray.origin[axis] = point[axis] - steps * direction[axis];
    ray.direction[axis] = direction[axis];
  }
  return ray;
}

Ray between(const Point &origin, const Point &aim) {
  Ray ray{};
  for (int axis = 0; axis < 3; ++axis) {
    ray.origin[axis] = origin[axis];
    ray.direction[axis] = aim[axis] - origin[axis];
  }
  return ray;
}

void randomPoint(RandomSource &random, const RayTarget &target, Point &point, double reach) {
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = target.extent[axis];
    point[axis] = static_cast<float>(random.real(-reach * extent, (1 + reach) * extent));
  }
}

void latticePoint(RandomSource &random, const RayTarget &target, Point &point) {
  const bool ofVoxel = !target.voxels.empty() && random.flip();
  const Int3 cell = ofVoxel ? randomCell(random, target) : Int3{};
  for (int axis = 0; axis < 3; ++axis)
    point[axis] = static_cast<float>(ofVoxel ? cell[axis] + random.integer(0, 1)
                                             : random.integer(0, target.extent[axis]));
}

Int3 randomCell(RandomSource &random, const RayTarget &target) {
  if (!target.voxels.empty() && random.flip())
    return target
        .voxels[static_cast<std::size_t>(random.integer(0, static_cast<int>(target.voxels.size()) - 1))];
  Int3 cell;
  for (int axis = 0; axis < 3; ++axis)
    cell[axis] = random.integer(0, target.extent[axis] - 1);
  return cell;
}

void wholeDirection(RandomSource &random, Point &direction, int most) {
  do {
    for (float &component : direction)
      component = static_cast<float>(random.integer(-most, most));
  } while (direction[0] == 0 && direction[1] == 0 && direction[2] == 0);
}

Ray axisParallel(RandomSource &random, const RayTarget &target, int onLattice) {
  const Int3 extent = target.extent, cell = randomCell(random, target);
  const int along = random.integer(0, 2), first = random.integer(1, 2);
  Ray ray{};
  for (int turn = 0; turn < 3; ++turn) {
    const int axis = (along + turn) % 3;
    const bool lattice = onLattice == 2 || (onLattice == 1 && turn == first);
    const float low = static_cast<float>(cell[axis]);
    ray.origin[axis] = lattice ? low + static_cast<float>(random.integer(0, 1)) : low + 0.5f;
    ray.direction[axis] = 0.0f * random.sign();
  }
  const float start = static_cast<float>(random.integer(-extent[along], 2 * extent[along]));
  const float middle = static_cast<float>(extent[along]) / 2;
  ray.origin[along] = random.flip() ? start : start + 0.25f;
  const float inward = ray.origin[along] < middle ? 1.0f : -1.0f;
  ray.direction[along] = inward * (random.flip() ? 1.0f : static_cast<float>(random.real(0.1, 10)));
  return ray;
}

} // namespace voxc::oracle
