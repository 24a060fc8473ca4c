// From the buffers to a walk, and back.

Bounds bounds_of(uint at) { return bounds_between(load_tmin(at), load_tmax(at)); }

// Whether a walk is where it may go on.
bool is_under_way(const Walk walk) { return is_in_volume(walk.open >= 0 ? ~walk.cell : walk.cell); }

// The walk of a ray that was left: -2 - cell in place of a voxel, what is open in place of its colour, its axis in place of
// t. One of -1 has not begun.
Walk left_walk(uint at) {
  HitWords left = load_hit(at);
  Walk walk = walk_at(-2 - ivec3(left.voxel));
  walk.axis = int(left.t);
  walk.is_within = int(left.rgba) == WITHIN;
  walk.open = max(int(left.rgba), CLOSED);
  walk.cell = walk.open >= 0 ? ~walk.cell : walk.cell;
  words_read = is_under_way(walk) ? left.last : 0u;
  walk.lookups = words_read;
  return walk;
}

HitWords words_of_left(const Walk walk) {
  ivec3 voxel = -2 - (walk.open >= 0 ? ~walk.cell : walk.cell);
  uint count = COUNT_WORDS ? words_read : walk.lookups;
  return HitWords(uvec3(voxel), uint(walk.open), ARRIVAL || BOUNDED ? uint(walk.axis) : 0u, count);
}

// A hit is its voxel, if that is asked. A miss is -1. One that would not have ended is told by a cell far below.
HitWords words_of(const Walk walk, bool hit, const Arrival arrival) {
  HitWords words;
  words.voxel = uvec3(hit ? (VOXEL ? walk.cell : ivec3(0)) : ivec3(walk.steps_left < 0 ? -0x7fffffff : -1));
  words.rgba = COLOUR && hit ? (PAGED ? walk.voxel : colour_of(walk)) : 0u;
  words.t = T && hit ? arrival.t : 0u;
  words.last = COUNT_WORDS ? words_read : walk.lookups;
  if (FACE && !COUNT_WORDS && !COUNT_LOOKUPS)
    words.last = hit ? arrival.face : 0u;
  return words;
}

// The same of a miss, or where nothing is asked of an arrival.
HitWords words_without_arrival(const Walk walk, bool hit) {
  Arrival none;
  return words_of(walk, hit, none);
}
