// One invocation a ray: from the buffers to a walk, and back.

uvec3 load_bits(uint at) { return uvec3(ray_words[at], ray_words[at + 1u], ray_words[at + 2u]); }

%if cut
// False if the device has begun to end loops early (Mesa's llvmpipe does after 65535 turns in all). No compiler knows
// ray_count, and so how often this one ought to turn.
bool loops_are_whole() {
  uint wanted = 1u + min(ray_count, 1u);
  uint turns = 0u;
  while (turns < wanted)
    turns++;
  return turns == wanted;
}

%end
%if apart
// The walk of a ray that an earlier dispatch has left: -2 - cell in place of a voxel, what is open in place of its colour, its
// axis in place of t. One of -1 has not begun.
Walk left_walk(uint at) {
  Walk walk = walk_at(-2 - ivec3(hit_words[at], hit_words[at + 1u], hit_words[at + 2u]), int(hit_words[at + 4u]));
  walk.open = max(int(hit_words[at + 3u]), CLOSED);
  walk.cell = walk.open >= 0 ? ~walk.cell : walk.cell;
  bool has_begun = is_in_volume(walk.open >= 0 ? ~walk.cell : walk.cell);
  walk.lookups = words_read = has_begun ? hit_words[at + 5u] : 0u;
  return walk;
}

void store_left(uint at, const Walk walk) {
  ivec3 voxel = -2 - (walk.open >= 0 ? ~walk.cell : walk.cell);
  hit_words[at] = uint(voxel.x);
  hit_words[at + 1u] = uint(voxel.y);
  hit_words[at + 2u] = uint(voxel.z);
  hit_words[at + 3u] = uint(walk.open);
  hit_words[at + 4u] = uint(walk.axis);
  hit_words[at + 5u] = COUNT_WORDS ? words_read : walk.lookups;
}

// Puts a ray on the list of those that are left.
void leave(uint ray) {
  uint place = atomicAdd(left_count, 1u);
  left_rays[place] = ray;
  if ((place & 63u) == 0u)
    atomicAdd(left_groups[0], 1u);
}

%end
// A hit is its voxel. A miss is -1. One that would not have ended is told by a cell far below.
void store(uint at, const Walk walk, bool hit, uint t) {
  ivec3 voxel = hit ? walk.cell : ivec3(walk.steps_left < 0 ? -0x7fffffff : -1);
  hit_words[at] = uint(voxel.x);
  hit_words[at + 1u] = uint(voxel.y);
  hit_words[at + 2u] = uint(voxel.z);
  hit_words[at + 3u] = hit ? colour_of(walk) : 0u;
  hit_words[at + 4u] = hit ? t : 0u;
  hit_words[at + 5u] = COUNT_WORDS ? words_read : walk.lookups;
}

void main() {
%if apart
  uint number = gl_GlobalInvocationID.x;
  if (number >= (task == LEFT_OVER ? left_count : ray_count))
    return;
  uint ray = task == LEFT_OVER ? left_rays[number] : first_ray + number;
  uint at = 6u * ray;
  Walk walk = walk_at(ivec3(-1), -1);
%if cut
  if (task == CUT_OFF && int(hit_words[at]) > -2)
    return;
%end
  if (task != ALL)
    walk = left_walk(at);
  uint t = 0u;
  bool hit = trace(load_bits(at), load_bits(at + 3u), walk, t);
%if cut
  // A walk that is still inside the volume without a hit, or whose t may not be whole, was cut off by the device.
  if (SETTLES && hit && !loops_are_whole())
    hit = false;
  bool is_left = walk.open != CLOSED || (!hit && is_in_volume(walk.cell));
%else
  bool is_left = walk.open != CLOSED;
%end
  if (is_left)
    store_left(at, walk);
  else
    store(at, walk, hit, t);
  if (!SETTLES && is_left)
    leave(ray);
%else
  Walk walk = walk_at(ivec3(-1), -1);
  uint t = 0u;
  bool hit = trace(load_bits(0u), load_bits(3u), walk, t);
  store(0u, walk, hit, t);
%end
}
