// From the buffers to a traversal, and back.

Bounds bounds_of(uint at) { return bounds_between(load_tmin(at), load_tmax(at)); }

// Whether a traversal is where it may go on.
bool is_under_way(const Traversal traversal) {
  return is_in_volume(traversal.pending_step >= 0 ? ~traversal.cell : traversal.cell);
}

// The traversal of a ray that was left: -2 - cell in place of a voxel, what is open in place of its colour, its axis in place of
// t. One of -1 has not begun.
Traversal deferred_traversal(uint at) {
  HitWords left = load_hit(at);
  Traversal traversal = traversal_at(-2 - ivec3(left.voxel));
  traversal.axis = int(left.t);
  traversal.is_within = int(left.rgba) == IN_BOUNDS;
  traversal.pending_step = max(int(left.rgba), NO_PENDING_STEP);
  traversal.cell = traversal.pending_step >= 0 ? ~traversal.cell : traversal.cell;
  words_read = is_under_way(traversal) ? left.last : 0u;
  traversal.lookups = words_read;
  return traversal;
}

HitWords words_of_deferred(const Traversal traversal) {
  ivec3 voxel = -2 - (traversal.pending_step >= 0 ? ~traversal.cell : traversal.cell);
  uint count = COUNT_WORDS ? words_read : traversal.lookups;
  return HitWords(uvec3(voxel), uint(traversal.pending_step), ARRIVAL || BOUNDED ? uint(traversal.axis) : 0u, count);
}

// A hit is its voxel, if that is asked. A miss is -1. One that would not have ended is told by a cell far below.
HitWords words_of(const Traversal traversal, bool hit, const Arrival arrival) {
  HitWords words;
  words.voxel = uvec3(hit ? (VOXEL ? traversal.cell : ivec3(0)) : ivec3(traversal.steps_left < 0 ? -0x7fffffff : -1));
  words.rgba = COLOUR && hit ? (PAGED ? traversal.voxel : colour_of(traversal)) : 0u;
  words.t = T && hit ? arrival.t : 0u;
  words.last = COUNT_WORDS ? words_read : traversal.lookups;
  if (FACE && !COUNT_WORDS && !COUNT_LOOKUPS)
    words.last = hit ? arrival.face : 0u;
  return words;
}

// The same of a miss, or where nothing is asked of an arrival.
HitWords words_without_arrival(const Traversal traversal, bool hit) {
  Arrival none;
  return words_of(traversal, hit, none);
}
