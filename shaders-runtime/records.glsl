// Rays and hits in their buffers. `at` is where the words of a hit begin: six for each ray.

// What is stored of a ray: a hit, or where its walk was left.
struct HitWords {
  uvec3 voxel;
  uint rgba;
  uint t;
  uint last; // ${sixth-word}.
};

%if packets
%if bounded
uint ray_at(uint at) { return at / 6u * 8u; }

uvec3 load_origin(uint at) { return uvec3(ray_words[ray_at(at)], ray_words[ray_at(at) + 1u], ray_words[ray_at(at) + 2u]); }
uint load_tmin(uint at) { return ray_words[ray_at(at) + 3u]; }
uvec3 load_direction(uint at) { return uvec3(ray_words[ray_at(at) + 4u], ray_words[ray_at(at) + 5u], ray_words[ray_at(at) + 6u]); }
uint load_tmax(uint at) { return ray_words[ray_at(at) + 7u]; }
%else
uvec3 load_origin(uint at) { return uvec3(ray_words[at], ray_words[at + 1u], ray_words[at + 2u]); }
%if point
%else
uvec3 load_direction(uint at) { return uvec3(ray_words[at + 3u], ray_words[at + 4u], ray_words[at + 5u]); }
%end
%end

void store_hit(uint at, const HitWords hit) {
  hit_words[at] = hit.voxel.x;
  hit_words[at + 1u] = hit.voxel.y;
  hit_words[at + 2u] = hit.voxel.z;
  hit_words[at + 3u] = hit.rgba;
  hit_words[at + 4u] = hit.t;
  hit_words[at + 5u] = hit.last;
}
%if point
%else

HitWords load_hit(uint at) {
  uvec3 voxel = uvec3(hit_words[at], hit_words[at + 1u], hit_words[at + 2u]);
  return HitWords(voxel, hit_words[at + 3u], hit_words[at + 4u], hit_words[at + 5u]);
}
%end
%else
// A device loads and stores several words at once in the time of one.
%if bounded
uvec4 first_half(uint at) { return ray_halves[at / 6u * 2u]; }
uvec4 second_half(uint at) { return ray_halves[at / 6u * 2u + 1u]; }

uvec3 load_origin(uint at) { return first_half(at).xyz; }
uint load_tmin(uint at) { return first_half(at).w; }
uvec3 load_direction(uint at) { return second_half(at).xyz; }
uint load_tmax(uint at) { return second_half(at).w; }
%else
uvec3 load_origin(uint at) {
  uvec2 first = ray_pairs[at / 2u], second = ray_pairs[at / 2u + 1u];
  return uvec3(first, second.x);
}
%if point
%else

uvec3 load_direction(uint at) {
  uvec2 second = ray_pairs[at / 2u + 1u], third = ray_pairs[at / 2u + 2u];
  return uvec3(second.y, third);
}
%end
%end

void store_hit(uint at, const HitWords hit) {
  hit_pairs[at / 2u] = hit.voxel.xy;
  hit_pairs[at / 2u + 1u] = uvec2(hit.voxel.z, hit.rgba);
  hit_pairs[at / 2u + 2u] = uvec2(hit.t, hit.last);
}
%if point
%else

HitWords load_hit(uint at) {
  uvec2 first = hit_pairs[at / 2u], second = hit_pairs[at / 2u + 1u], third = hit_pairs[at / 2u + 2u];
  return HitWords(uvec3(first, second.x), second.y, third.x, third.y);
}
%end
%end
