// From the buffers to a walk, and back.

uvec3 load_bits(uint at) { return uvec3(ray_words[at], ray_words[at + 1u], ray_words[at + 2u]); }
%if bounded

// Where a ray begins whose hit begins at `at`: it has eight words, and a hit has six.
uint ray_at(uint at) { return at / 6u * 8u; }

Bounds load_bounds(uint at) { return bounds_between(ray_words[ray_at(at) + 3u], ray_words[ray_at(at) + 7u]); }
%end

%if axis
// The walk of a ray that was left: -2 - cell in place of a voxel, what is open in place of its colour, its axis in place of
// t. One of -1 has not begun.
%else
// The walk of a ray that was left: -2 - cell in place of a voxel, what is open in place of its colour. One of -1 has not
// begun.
%end
Walk left_walk(uint at) {
  Walk walk = walk_at(-2 - ivec3(hit_words[at], hit_words[at + 1u], hit_words[at + 2u]));
%if axis
  walk.axis = int(hit_words[at + 4u]);
%end
%if bounded
%if packets
  walk.is_within = int(hit_words[at + 3u]) == WITHIN;
%end
%end
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
%if axis
  hit_words[at + 4u] = uint(walk.axis);
%end
  hit_words[at + 5u] = COUNT_WORDS ? words_read : walk.lookups;
}

// A hit is its voxel, if that is asked. A miss is -1. One that would not have ended is told by a cell far below.
void store(uint at, const Walk walk, bool hit${and-an-arrival}) {
%if voxel
  ivec3 voxel = hit ? walk.cell : ivec3(walk.steps_left < 0 ? -0x7fffffff : -1);
%else
  ivec3 voxel = ivec3(hit ? 0 : walk.steps_left < 0 ? -0x7fffffff : -1);
%end
  hit_words[at] = uint(voxel.x);
  hit_words[at + 1u] = uint(voxel.y);
  hit_words[at + 2u] = uint(voxel.z);
%if colour
%if paged
  hit_words[at + 3u] = hit ? walk.voxel : 0u;
%else
  hit_words[at + 3u] = hit ? colour_of(walk) : 0u;
%end
%else
  hit_words[at + 3u] = 0u;
%end
%if t
  hit_words[at + 4u] = hit ? arrival.t : 0u;
%else
  hit_words[at + 4u] = 0u;
%end
  hit_words[at + 5u] = COUNT_WORDS ? words_read : walk.lookups;
%if face
  if (!COUNT_WORDS && !COUNT_LOOKUPS)
    hit_words[at + 5u] = hit ? arrival.face : 0u;
%end
}
