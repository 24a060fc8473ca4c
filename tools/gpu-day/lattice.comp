#version 460
// Rays of a lattice of 1/256 voxel, and their exact hits, in integers alone: the algorithm of Amanatides and Woo ("A fast voxel traversal
// algorithm for ray tracing", 1987) with times that are quotients of integers. It shares nothing with the kernels that it checks.
// Components of an origin are below 2^20 units, those of a direction below 2^10, so that all products fit 31 bits.
layout(local_size_x = 64) in;

layout(std430, set = 0, binding = 0) readonly buffer Cells { uint cells[]; }; // A word a voxel, x fastest; 0 where it is empty.
layout(std430, set = 0, binding = 1) writeonly buffer Rays { float rays[]; };
layout(std430, set = 0, binding = 2) writeonly buffer Hits { uint hits[]; };
layout(push_constant) uniform Draw {
  uint first; // The number of the first ray, of all that are ever drawn.
  uint count;
  uint seed;
  int edge; // Voxels along each axis.
};

const int UNIT = 256; // Of a voxel's side.

// ---- Random numbers: the mixer of PCG (O'Neill 2014) over a counter ----

uint state;

uint draw() {
  state = state * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
  return (word >> 22) ^ word;
}

int between(int least, int most) { return least + int(draw() % uint(most - least + 1)); }

ivec3 between(ivec3 least, ivec3 most) {
  int x = between(least.x, most.x);
  int y = between(least.y, most.y);
  return ivec3(x, y, between(least.z, most.z));
}

// ---- Rays that are hard to trace ----

struct LatticeRay {
  ivec3 origin; // In units.
  ivec3 direction;
};

const uint KINDS = 8u;

// A workgroup draws rays of one kind: those from far away take more steps than others.
LatticeRay draw_ray(uint kind) {
  int side = edge * UNIT;
  LatticeRay ray = LatticeRay(between(ivec3(-side), ivec3(2 * side)), between(ivec3(-1023), ivec3(1023)));
  ivec3 corner = between(ivec3(0), ivec3(edge)) * UNIT;
  switch (int(kind)) {
  case 0: // Anywhere.
    break;
  case 1: { // Along an axis, often within a face or along an edge.
    int axis = between(0, 2);
    ivec3 along = ivec3(axis == 0, axis == 1, axis == 2);
    ray.direction = along * (between(0, 1) * 2 - 1) * between(1, 1023);
    ray.origin = between(0, 1) == 0 ? corner : ray.origin & ~127;
    ray.origin -= ray.direction * between(0, 255);
    break;
  }
  case 2: // Along diagonals, from middles and corners.
    ray.direction = between(ivec3(-1), ivec3(1)) * between(1, 1023);
    ray.origin = corner + between(ivec3(-2), ivec3(2)) * 128;
    break;
  case 3: // Through a corner.
    ray.direction = between(ivec3(-63), ivec3(63));
    ray.origin = corner - ray.direction * between(0, 255);
    break;
  case 4: // Past a corner by a unit.
    ray.direction = between(ivec3(-63), ivec3(63));
    ray.origin = corner + between(ivec3(-1), ivec3(1)) - ray.direction * between(0, 255);
    break;
  case 5: { // Nearly along a diagonal.
    int speed = between(2, 1022);
    ray.direction = (ivec3(speed) + between(ivec3(-1), ivec3(1))) * (between(ivec3(0), ivec3(1)) * 2 - 1);
    ray.origin = corner + between(ivec3(-1), ivec3(1));
    break;
  }
  case 6: // From within, often from a face.
    ray.origin = between(ivec3(0), ivec3(side - 1)) & (between(0, 1) == 0 ? ~0 : ~255);
    break;
  default: // From far away, grazing what it aims at.
    ray.direction[between(0, 2)] /= 128;
    ray.origin = corner - ray.direction * between(0, 511);
    break;
  }
  if (ray.direction == ivec3(0))
    ray.direction.x = 1;
  return ray;
}

// ---- The exact hit ----

// |to - from| / |direction| of one axis, as a quotient of integers.
struct Moment {
  int way;
  int speed;
};

const Moment NEVER = Moment(1, 0);

bool is_before(Moment a, Moment b) { return a.way * b.speed < b.way * a.speed; }
bool is_same(Moment a, Moment b) { return a.way * b.speed == b.way * a.speed; }

// When the ray leaves its cell on an axis: a coordinate that falls leaves at the low face, just after it is there.
Moment leaving(LatticeRay ray, ivec3 cell, int axis) {
  int speed = ray.direction[axis];
  if (speed == 0)
    return NEVER;
  int face = (speed > 0 ? cell[axis] + 1 : cell[axis]) * UNIT;
  return Moment(abs(face - ray.origin[axis]), abs(speed));
}

// Whether the ray may come to the volume from this cell on.
bool may_come(LatticeRay ray, ivec3 cell) {
  for (int axis = 0; axis < 3; axis++)
    if ((cell[axis] < 0 && ray.direction[axis] <= 0) || (cell[axis] >= edge && ray.direction[axis] >= 0))
      return false;
  return true;
}

bool is_inside(ivec3 cell) { return all(lessThan(uvec3(cell), uvec3(edge))); }

uint word_at(ivec3 cell) { return is_inside(cell) ? cells[(cell.z * edge + cell.y) * edge + cell.x] : 0u; }

struct Arrival {
  ivec3 cell;
  Moment when;
};

// Moves on: of all that leave first, those whose coordinates rise, or else those that fall.
void step(LatticeRay ray, inout Arrival at) {
  Moment when = leaving(ray, at.cell, 0);
  for (int axis = 1; axis < 3; axis++) {
    Moment other = leaving(ray, at.cell, axis);
    if (is_before(other, when))
      when = other;
  }
  ivec3 rises = ivec3(0), falls = ivec3(0);
  for (int axis = 0; axis < 3; axis++)
    if (ray.direction[axis] != 0 && is_same(leaving(ray, at.cell, axis), when)) {
      rises[axis] = int(ray.direction[axis] > 0);
      falls[axis] = int(ray.direction[axis] < 0);
    }
  at.cell += rises != ivec3(0) ? rises : -falls;
  at.when = when;
}

int rounded_up(int way, int speed) { return way >= 0 ? (way + speed - 1) / speed : -(-way / speed); }
int rounded_down(int way, int speed) { return -rounded_up(-way, speed); }

// The cell of an axis just before a moment: a coordinate that is on a face then has not passed it yet.
int cell_before(LatticeRay ray, Moment when, int axis) {
  int speed = ray.direction[axis];
  int way = ray.origin[axis] * when.speed + speed * when.way;
  int unit = UNIT * when.speed;
  return speed > 0 ? rounded_up(way, unit) - 1 : rounded_down(way, unit);
}

// Puts a ray that begins outside to where it is about to pass the last of the volume's faces that it has to pass: no cell before that is
// in the volume, and steps through all of them would take most of the time.
void come_near(LatticeRay ray, inout Arrival at) {
  Moment last = Moment(0, 1);
  for (int axis = 0; axis < 3; axis++) {
    bool rises = ray.direction[axis] > 0;
    if (rises ? at.cell[axis] < 0 : ray.direction[axis] < 0 && at.cell[axis] >= edge) {
      Moment entry = Moment(abs((rises ? 0 : edge * UNIT) - ray.origin[axis]), abs(ray.direction[axis]));
      if (is_before(last, entry))
        last = entry;
    }
  }
  if (last.way == 0)
    return;
  for (int axis = 0; axis < 3; axis++)
    if (ray.direction[axis] != 0)
      at.cell[axis] = cell_before(ray, last, axis);
}

// way / (256 speed) to the nearest float32, ties to even, by long division.
uint rounded(Moment when) {
  if (when.way == 0)
    return 0u;
  uint speed = uint(when.speed);
  uint quotient = uint(when.way) / speed;
  uint rest = uint(when.way) % speed;
  int exponent = -8;
  while (quotient < (1u << 25)) { // 26 bits: two behind those of a float32.
    rest <<= 1;
    quotient = quotient << 1 | uint(rest >= speed);
    rest -= rest >= speed ? speed : 0u;
    exponent--;
  }
  bool is_more = rest != 0u || (quotient & 1u) != 0u;
  bool is_half = (quotient & 2u) != 0u;
  uint kept = quotient >> 2;
  if (is_half && (is_more || (kept & 1u) != 0u))
    kept++;
  return uint(exponent + 2 + 23 + 127 - 1 << 23) + kept; // The first bit of `kept` adds the 1; a carry the next exponent.
}

void main() {
  uint number = gl_GlobalInvocationID.x;
  if (number >= count)
    return;
  state = (first + number) * 2654435761u ^ seed;
  draw();
  LatticeRay ray = draw_ray((first + number) / gl_WorkGroupSize.x % KINDS);
  for (int axis = 0; axis < 3; axis++) {
    rays[6u * number + axis] = float(ray.origin[axis]) / float(UNIT);
    rays[6u * number + 3u + axis] = float(ray.direction[axis]);
  }
  Arrival at = Arrival(ray.origin >> 8, Moment(0, 1));
  come_near(ray, at);
  uint word = word_at(at.cell);
  while (word == 0u && may_come(ray, at.cell)) {
    step(ray, at);
    word = word_at(at.cell);
  }
  ivec3 cell = word != 0u ? at.cell : ivec3(-1);
  for (int axis = 0; axis < 3; axis++)
    hits[6u * number + axis] = uint(cell[axis]);
  hits[6u * number + 3u] = word;
  hits[6u * number + 4u] = word != 0u ? rounded(at.when) : 0u;
  hits[6u * number + 5u] = 0u;
}
