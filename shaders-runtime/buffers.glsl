// From the buffers to a walk, and back.
%if bounded

Bounds bounds_of(uint at) { return bounds_between(load_tmin(at), load_tmax(at)); }
%end

%if axis
// The walk of a ray that was left: -2 - cell in place of a voxel, what is open in place of its colour, its axis in place of
// t. One of -1 has not begun.
%else
// The walk of a ray that was left: -2 - cell in place of a voxel, what is open in place of its colour. One of -1 has not
// begun.
%end
Walk left_walk(uint at) {
  HitWords left = load_hit(at);
  Walk walk = walk_at(-2 - ivec3(left.voxel));
%if axis
  walk.axis = int(left.t);
%end
%if bounded
%if packets
  walk.is_within = int(left.rgba) == WITHIN;
%end
%end
  walk.open = max(int(left.rgba), CLOSED);
  walk.cell = walk.open >= 0 ? ~walk.cell : walk.cell;
  bool has_begun = is_in_volume(walk.open >= 0 ? ~walk.cell : walk.cell);
  walk.lookups = words_read = has_begun ? left.last : 0u;
  return walk;
}

HitWords words_of_left(const Walk walk) {
  ivec3 voxel = -2 - (walk.open >= 0 ? ~walk.cell : walk.cell);
%if axis
  return HitWords(uvec3(voxel), uint(walk.open), uint(walk.axis), COUNT_WORDS ? words_read : walk.lookups);
%else
  return HitWords(uvec3(voxel), uint(walk.open), 0u, COUNT_WORDS ? words_read : walk.lookups);
%end
}

// A hit is its voxel, if that is asked. A miss is -1. One that would not have ended is told by a cell far below.
HitWords words_of(const Walk walk, bool hit${and-an-arrival}) {
  HitWords words;
%if voxel
  words.voxel = uvec3(hit ? walk.cell : ivec3(walk.steps_left < 0 ? -0x7fffffff : -1));
%else
  words.voxel = uvec3(ivec3(hit ? 0 : walk.steps_left < 0 ? -0x7fffffff : -1));
%end
%if colour
%if paged
  words.rgba = hit ? walk.voxel : 0u;
%else
  words.rgba = hit ? colour_of(walk) : 0u;
%end
%else
  words.rgba = 0u;
%end
%if t
  words.t = hit ? arrival.t : 0u;
%else
  words.t = 0u;
%end
  words.last = COUNT_WORDS ? words_read : walk.lookups;
%if face
  if (!COUNT_WORDS && !COUNT_LOOKUPS)
    words.last = hit ? arrival.face : 0u;
%end
  return words;
}
