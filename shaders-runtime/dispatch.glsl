// One invocation a ray.

// False if the device has begun to end loops early (Mesa's llvmpipe does after 65535 turns in all). No compiler knows
// ray_count, and so how often this one ought to turn.
bool loops_are_whole() {
  uint wanted = 1u + min(ray_count, 1u);
  uint turns = 0u;
  while (turns < wanted)
    turns++;
  return turns == wanted;
}

// Traces a ray, from where it was left if it `goes_on`. True if it is left, again.
bool trace_ray(uint ray_number, bool goes_on) {
  uint at = 6u * ray_number;
  Walk walk = walk_at(ivec3(-1));
  if (goes_on)
    walk = left_walk(at);
  uvec3 direction = load_direction(at);
  uint root = load_word(0u); // Leads to level 1, unless the volume is empty.
  Ray ray;
  bool hit = false;
  if (BOUNDED) {
    Bounds bounds = bounds_of(at);
    hit = begin_walk(load_origin(at), direction, root, ray, walk) && bound_walk(ray, walk, bounds);
    if (hit) {
      skip_to(ray, walk, bounds.tmin);
      hit = walk_within(ray, walk, root, bounds);
    }
  } else {
    hit = begin_walk(load_origin(at), direction, root, ray, walk) && walk_on(ray, walk, root);
  }
  hit = end_walk(load_origin(at), direction, walk, hit);
  if (PAGED) {
    if (COLOUR && hit)
      walk.voxel = colour_of(walk);
    hit = hit && !lacks_page; // Else it waits where it is.
  }
  Arrival arrival;
  if (ARRIVAL) {
    bool sure;
    arrival = arrival_at(ray, walk, hit, sure);
    walk.open = sure ? walk.open : AGAIN;
  }
  // A walk that is still inside the volume without a hit, or whose arrival may not be whole, was cut off by the device.
  if (CUT && SETTLES && hit && !loops_are_whole())
    hit = false;
  bool is_left = walk.open != CLOSED;
  if (CUT || PAGED)
    is_left = is_left || (!hit && (BOUNDED ? is_in_reach(walk) : is_in_volume(walk.cell)));
  HitWords words = words_of(walk, hit, arrival);
  if (is_left)
    words = words_of_left(walk);
  store_hit(at, words);
  return is_left;
}

// Puts a ray on the list of those that are left.
void leave(uint ray_number) {
  uint place = atomicAdd(left_count, 1u);
  left_rays[place] = ray_number;
  if (place % gl_WorkGroupSize.x == 0u)
    atomicAdd(left_groups[0], 1u);
}

void main() {
  uint number = gl_GlobalInvocationID.x;
  bool goes_on = SETTLES && task != ALL; // A dispatch that does not settle begins all its rays.
  bool is_listed = goes_on && task == LEFT_OVER;
  if (number >= (is_listed ? left_count : ray_count))
    return;
  uint ray_number = is_listed ? left_rays[number] : first_ray + number;
  if ((CUT || PAGED) && goes_on && task == CUT_OFF && int(load_hit(6u * ray_number).voxel.x) > -2)
    return;
  if (trace_ray(ray_number, goes_on) && !SETTLES && !(PAGED && lacks_page))
    leave(ray_number);
}
