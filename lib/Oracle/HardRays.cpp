// The classes of hard rays: a generator each, and the table of them.
#include "voxc/Oracle/HardRays.h"

#include "RandomSource.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace voxc {

namespace {

/// A ray from `point` - `steps` * `direction`: exact for small integers and halves.
Ray backedOff(const float (&point)[3], const float (&direction)[3], float steps) {
  Ray ray{};
  for (int axis = 0; axis < 3; ++axis) {
    ray.origin[axis] = point[axis] - steps * direction[axis];
    ray.direction[axis] = direction[axis];
  }
  return ray;
}

Ray between(const float (&origin)[3], const float (&target)[3]) {
  Ray ray{};
  for (int axis = 0; axis < 3; ++axis) {
    ray.origin[axis] = origin[axis];
    ray.direction[axis] = target[axis] - origin[axis];
  }
  return ray;
}

void randomPoint(RandomSource &random, Int3 extent, float (&point)[3], double reach = 0) {
  for (int axis = 0; axis < 3; ++axis)
    point[axis] = static_cast<float>(random.real(-reach * extent[axis], (1 + reach) * extent[axis]));
}

void latticePoint(RandomSource &random, Int3 extent, float (&point)[3]) {
  for (int axis = 0; axis < 3; ++axis)
    point[axis] = static_cast<float>(random.integer(0, extent[axis]));
}

/// Small whole components, not all of them zero.
void latticeDirection(RandomSource &random, float (&direction)[3]) {
  do {
    for (float &component : direction)
      component = static_cast<float>(random.integer(-3, 3));
  } while (direction[0] == 0 && direction[1] == 0 && direction[2] == 0);
}

/// Plus or minus 2^e, e in [low, high].
float signedPower(RandomSource &random, int low, int high) {
  const float sign = random.sign();
  return std::ldexp(sign, random.integer(low, high));
}

float nudged(RandomSource &random, float value) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const int way = random.integer(-1, 1);
  return way == 0 ? value : std::nextafter(value, static_cast<float>(way) * kInfinity);
}

/// Along an axis, with `onLattice` of the two other coordinates whole and the rest at a cell's centre.
Ray axisParallel(RandomSource &random, Int3 extent, int onLattice) {
  const int along = random.integer(0, 2), first = random.integer(1, 2);
  Ray ray{};
  for (int turn = 0; turn < 3; ++turn) {
    const int axis = (along + turn) % 3;
    const bool lattice = onLattice == 2 || (onLattice == 1 && turn == first);
    const float centre = static_cast<float>(random.integer(0, extent[axis] - 1)) + 0.5f;
    ray.origin[axis] = lattice ? static_cast<float>(random.integer(0, extent[axis])) : centre;
    ray.direction[axis] = 0.0f * random.sign();
  }
  const float start = static_cast<float>(random.integer(-extent[along], 2 * extent[along]));
  const float middle = static_cast<float>(extent[along]) / 2;
  ray.origin[along] = random.flip() ? start : start + 0.25f;
  const float inward = ray.origin[along] < middle ? 1.0f : -1.0f;
  ray.direction[along] = inward * (random.flip() ? 1.0f : static_cast<float>(random.real(0.1, 10)));
  return ray;
}

Ray axisCentre(RandomSource &random, Int3 extent) { return axisParallel(random, extent, 0); }
Ray axisFace(RandomSource &random, Int3 extent) { return axisParallel(random, extent, 1); }
Ray axisEdge(RandomSource &random, Int3 extent) { return axisParallel(random, extent, 2); }

Ray diagonal(RandomSource &random, Int3 extent) {
  float point[3], direction[3];
  latticePoint(random, extent, point);
  latticeDirection(random, direction);
  const int longest = std::max({extent.x, extent.y, extent.z});
  const int steps = random.flip() ? 0 : random.integer(0, longest);
  Ray ray = backedOff(point, direction, static_cast<float>(steps));
  const float scale = std::ldexp(1.0f, random.integer(-3, 3));
  for (float &component : ray.direction)
    component *= scale;
  return ray;
}

/// Through a corner of the grid, or a lattice point of one of its edges.
Ray corner(RandomSource &random, Int3 extent) {
  float point[3], direction[3];
  latticePoint(random, extent, point);
  const int free = random.integer(0, 3);
  for (int axis = 0; axis < 3; ++axis)
    if (axis != free)
      point[axis] = random.flip() ? static_cast<float>(extent[axis]) : 0.0f;
  latticeDirection(random, direction);
  return backedOff(point, direction, static_cast<float>(random.integer(0, 8)));
}

Ray boundaryUlp(RandomSource &random, Int3 extent) {
  Ray ray = random.flip() ? axisParallel(random, extent, random.integer(1, 2)) : diagonal(random, extent);
  for (float &component : ray.origin)
    component = nudged(random, component);
  if (random.flip())
    for (float &component : ray.direction)
      component = nudged(random, component);
  return ray;
}

Ray grazing(RandomSource &random, Int3 extent) {
  Ray ray = axisParallel(random, extent, random.integer(1, 2));
  for (float &component : ray.direction)
    if (component == 0 && random.flip())
      component = signedPower(random, -40, -2);
  return ray;
}

Ray outside(RandomSource &random, Int3 extent) {
  float origin[3], target[3];
  randomPoint(random, extent, origin, 1.5);
  randomPoint(random, extent, target);
  const int axis = random.integer(0, 2); // Off the grid on one axis at least.
  origin[axis] = static_cast<float>(random.flip() ? -random.real(0, 2) * extent[axis]
                                                  : random.real(1, 3) * extent[axis]);
  return between(origin, target);
}

Ray inside(RandomSource &random, Int3 extent) {
  float origin[3], target[3];
  random.flip() ? randomPoint(random, extent, origin) : latticePoint(random, extent, origin);
  randomPoint(random, extent, target, 1);
  return between(origin, target);
}

/// As a camera's: a direction of unit length, from the outside.
Ray camera(RandomSource &random, Int3 extent) {
  Ray ray = outside(random, extent);
  const float *d = ray.direction;
  const double length = std::sqrt(double{d[0]} * d[0] + double{d[1]} * d[1] + double{d[2]} * d[2]);
  for (float &component : ray.direction)
    component = static_cast<float>(component / length);
  return ray;
}

Ray tiny(RandomSource &random, Int3 extent) {
  Ray ray = random.flip() ? inside(random, extent) : diagonal(random, extent);
  const int common = random.flip() ? random.integer(0, 150) : 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int own = random.flip() ? random.integer(0, 150) : 0;
    ray.direction[axis] = std::ldexp(ray.direction[axis], -std::max(common, own));
    if (random.integer(0, 3) == 0)
      ray.origin[axis] = signedPower(random, -149, -20);
  }
  return ray;
}

Ray farAway(RandomSource &random, Int3 extent) {
  float target[3];
  random.flip() ? randomPoint(random, extent, target) : latticePoint(random, extent, target);
  const double distance = random.flip() ? random.real(1e4, 1e5) : random.real(1e5, 1e6);
  float origin[3];
  for (int axis = 0; axis < 3; ++axis)
    origin[axis] = target[axis] + static_cast<float>(distance * random.real(-1, 1));
  return between(origin, target);
}

/// Components up to the largest float32; half of the rays start at the same distance on every moving axis,
/// and so still meet the grid.
Ray huge(RandomSource &random, Int3 extent) {
  Ray ray = random.flip() ? inside(random, extent) : diagonal(random, extent);
  const bool aimed = random.flip();
  const float power = std::ldexp(1.0f, random.integer(60, 127));
  const float size = power * static_cast<float>(random.real(0.5, 1));
  for (int axis = 0; axis < 3; ++axis) {
    ray.direction[axis] = random.integer(0, 3) == 0 ? 0.0f : random.sign() * size;
    if (aimed && ray.direction[axis] != 0)
      ray.origin[axis] = -ray.direction[axis];
    else if (!aimed && random.integer(0, 3) == 0)
      ray.origin[axis] = random.sign() * std::numeric_limits<float>::max();
  }
  return ray;
}

Ray still(RandomSource &random, Int3 extent) {
  Ray ray = random.flip() ? outside(random, extent) : inside(random, extent);
  for (float &component : ray.direction)
    component = 0.0f * random.sign();
  return ray;
}

Ray notFinite(RandomSource &random, Int3 extent) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kBad[] = {kInfinity, -kInfinity, std::numeric_limits<float>::quiet_NaN()};
  Ray ray = inside(random, extent);
  float(&half)[3] = random.flip() ? ray.origin : ray.direction;
  half[random.integer(0, 2)] = kBad[random.integer(0, 2)];
  return ray;
}

constexpr HardRayClass kClasses[] = {
    {"camera", "unit directions from outside towards the volume", camera, 30},
    {"outside", "random lines from outside towards the volume", outside, 20},
    {"inside", "random lines from inside, half of them from lattice points", inside, 20},
    {"axis-centre", "axis-parallel through the centres of cells", axisCentre, 8},
    {"axis-face", "axis-parallel within a plane between cells", axisFace, 6},
    {"axis-edge", "axis-parallel along the edges of cells", axisEdge, 4},
    {"diagonal", "through lattice points along small whole directions", diagonal, 12},
    {"corner", "through the corners and edges of the grid", corner, 0},
    {"boundary-ulp", "a unit in the last place to either side of boundaries", boundaryUlp, 0},
    {"grazing", "almost parallel to a plane between cells, and close to it", grazing, 0},
    {"tiny", "tiny and denormal components", tiny, 0},
    {"far", "origins ten thousand to a million voxels away", farAway, 0},
    {"huge", "components up to the largest float32", huge, 0},
    {"still", "directions of zero length", still, 0},
    {"not-finite", "an infinite component, or one that is not a number", notFinite, 0},
};

const HardRayClass &shareHolder(unsigned percent) {
  const HardRayClass *row = kClasses;
  for (; percent >= row->verifyShare; ++row)
    percent -= row->verifyShare;
  return *row;
}

} // namespace

std::span<const HardRayClass> hardRayClasses() { return kClasses; }

std::vector<Ray> hardRays(Int3 extent, std::string_view className, std::size_t count, std::uint64_t seed) {
  const auto row = std::ranges::find(kClasses, className, &HardRayClass::name);
  if (row == std::end(kClasses))
    return {};
  RandomSource random(seed);
  std::vector<Ray> rays(count);
  std::ranges::generate(rays, [&] { return row->make(random, extent); });
  return rays;
}

std::vector<Ray> verifyRays(Int3 extent, std::size_t count, std::uint64_t seed) {
  RandomSource random(seed);
  std::vector<Ray> rays(count);
  std::ranges::generate(rays, [&] {
    const auto percent = static_cast<unsigned>(random.integer(0, 99));
    return shareHolder(percent).make(random, extent);
  });
  return rays;
}

} // namespace voxc
