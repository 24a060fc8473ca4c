// Where surfaces are, shaded by their faces: a ray from the eye, and no further ones. A pixel that lacks a page shows the cell that its ray
// has come to, and waits.
const vec3 UNKNOWN = vec3(0.3);

Texels texels_at(ivec2 here) {
  ivec2 pixel = ivec2(here.x, given.size.y - 1 - here.y);
  vec2 at = (vec2(pixel) + given.place) / vec2(given.size) * 2.0 - 1.0;
  at.y = -at.y;
  vec3 direction = way(at) / SPACING;
  voxc_scene_Hit hit;
  bool found = seen_first((given.eye + aside(at)) / SPACING, direction, false, hit);
  bool lacks = lacks_page();
  vec3 face = lies_at_cut(hit.t) ? cut_normal : hit.axis < 0 ? -direction : voxc_scene_normal(hit);
  vec3 colour = (lacks ? UNKNOWN : colour_of_word(hit.colour)) * (0.9 + 0.2 * face.y - 0.1 * abs(face.x));
  uint first = floatBitsToUint(hit.t) >> 12 << 12 | (hit.axis < 0 ? 6u : uint(2 * hit.axis + max(hit.side, 0))) << 9;
  return Texels(found || lacks ? uvec4(floatBitsToUint(colour), first) : uvec4(0u), uvec4(0u));
}
