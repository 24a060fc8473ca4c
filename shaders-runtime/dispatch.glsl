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
// A hit is its voxel. A miss is -1.
%if cut
// A walk that is still inside the volume without a hit, or whose t may not be whole, was
// cut short by the device; it is kept as -2 - cell, with its axis in place of t, to be resumed.
%end
// One that would not have ended is told by a cell far below.
void store(uint at, const Walk walk, bool found, uint t) {
%if cut
  bool hit = found && loops_are_whole();
  bool unfinished = !hit && is_in_volume(walk.cell);
  ivec3 voxel = hit ? walk.cell : unfinished ? -2 - walk.cell : ivec3(walk.axis == ENDLESS ? -0x7fffffff : -1);
%else
  bool hit = found;
  ivec3 voxel = hit ? walk.cell : ivec3(walk.axis == ENDLESS ? -0x7fffffff : -1);
%end
  hit_words[at] = uint(voxel.x);
  hit_words[at + 1u] = uint(voxel.y);
  hit_words[at + 2u] = uint(voxel.z);
  hit_words[at + 3u] = hit ? colour_of(walk.voxel) : 0u;
%if cut
  hit_words[at + 4u] = hit ? t : unfinished ? uint(walk.axis) : 0u;
%else
  hit_words[at + 4u] = hit ? t : 0u;
%end
  hit_words[at + 5u] = COUNT_WORDS ? words_read : walk.lookups;
}

void main() {
  if (gl_GlobalInvocationID.x >= ray_count)
    return;
  uint at = 6u * (first_ray + gl_GlobalInvocationID.x);
  Walk walk = walk_at(ivec3(-1), -1);
%if cut
  if (resumes != 0u) {
    walk.cell = -2 - ivec3(hit_words[at], hit_words[at + 1u], hit_words[at + 2u]);
    if (!is_in_volume(walk.cell))
      return;
    walk.axis = int(hit_words[at + 4u]);
    walk.lookups = words_read = hit_words[at + 5u];
  }
%end
  uint t = 0u;
  bool hit = trace(load_bits(at), load_bits(at + 3u), walk, t);
  store(at, walk, hit, t);
}
