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

// Traces a ray, from where it was deferred if it `goes_on`. True if it is deferred, again.
bool trace_ray(uint ray_number, bool goes_on) {
  uint at = 6u * ray_number;
  Traversal traversal = traversal_at(ivec3(-1));
  if (goes_on)
    traversal = deferred_traversal(at);
  uvec3 direction = load_direction(at);
  uint root = load_word(0u); // Leads to level 1, unless the volume is empty.
  Ray ray;
  bool hit = false;
  if (BOUNDED) {
    Bounds bounds = bounds_of(at);
    hit = begin_traversal(load_origin(at), direction, root, ray, traversal) && bound_traversal(ray, traversal, bounds);
    if (hit) {
      skip_to(ray, traversal, bounds.tmin);
      hit = traverse_within(ray, traversal, root, bounds);
    }
  } else {
    hit = begin_traversal(load_origin(at), direction, root, ray, traversal) && continue_traversal(ray, traversal, root);
  }
  hit = end_traversal(load_origin(at), direction, traversal, hit);
  if (PAGED) {
    if (COLOUR && hit)
      traversal.voxel = colour_of(traversal);
    hit = hit && !lacks_page; // Else it waits where it is.
  }
  Arrival arrival;
  if (ARRIVAL) {
    bool sure;
    arrival = arrival_at(ray, traversal, hit, sure);
    traversal.pending_step = sure ? traversal.pending_step : RETRY;
  }
  // A traversal that is still inside the volume without a hit, or whose arrival may not be whole, was cut off by the device.
  if (CUT && EXACT_FALLBACK && hit && !loops_are_whole())
    hit = false;
  bool is_deferred = traversal.pending_step != NO_PENDING_STEP;
  if (CUT || PAGED)
    is_deferred = is_deferred || (!hit && (BOUNDED ? is_in_reach(traversal) : is_in_volume(traversal.cell)));
  HitWords words = words_of(traversal, hit, arrival);
  if (is_deferred)
    words = words_of_deferred(traversal);
  store_hit(at, words);
  return is_deferred;
}

// Puts a ray on the list of those that are deferred.
void defer(uint ray_number) {
  uint place = atomicAdd(deferred_count, 1u);
  deferred_rays[place] = ray_number;
  if (place % gl_WorkGroupSize.x == 0u)
    atomicAdd(deferred_groups[0], 1u);
}

void main() {
  uint number = gl_GlobalInvocationID.x;
  bool goes_on = EXACT_FALLBACK && task != ALL; // A dispatch without the exact fallback begins all its rays.
  bool is_listed = goes_on && task == DEFERRED;
  if (number >= (is_listed ? deferred_count : ray_count))
    return;
  uint ray_number = is_listed ? deferred_rays[number] : first_ray + number;
  if ((CUT || PAGED) && goes_on && task == TRUNCATED && int(load_hit(6u * ray_number).voxel.x) > -2)
    return;
  if (trace_ray(ray_number, goes_on) && !EXACT_FALLBACK && !(PAGED && lacks_page))
    defer(ray_number);
}
