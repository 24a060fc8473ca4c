// Where surfaces are, shaded by their faces: a ray from the eye, and no further ones. A pixel that lacks a page shows the cell that its ray
// has come to, and waits.
uniform highp usampler2D before_sun;
uniform highp usampler2D before_told;
uniform bool is_again; // Only pixels that wait are traced, from the first whose turn it is to the one before the last.
uniform uvec2 turn;
uniform int number;
uniform ivec2 size;
uniform vec2 place; // Where in a pixel.
layout(location = 0) out uvec4 after_sun;
layout(location = 1) out uvec4 after_sky;
layout(location = 2) out uint told;

const vec3 UNKNOWN = vec3(0.3);

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  after_sky = uvec4(0u);
  if (is_again && stays(here, size.x, before_told, turn)) {
    after_sun = texelFetch(before_sun, here, 0);
    told = told_again(here, before_told);
    return;
  }
  begin_loads(uvec2(here), uint(number));
  ivec2 pixel = ivec2(here.x, size.y - 1 - here.y);
  vec2 at = (vec2(pixel) + place) / vec2(size) * 2.0 - 1.0;
  at.y = -at.y;
  vec3 direction = way(at) / SPACING;
  voxc_scene_Hit hit;
  bool found = seen_first((eye + aside(at)) / SPACING, direction, false, hit);
  bool lacks = voxc_scene_lacks_page;
  vec3 face = lies_at_cut(hit.t) ? cut_normal : hit.axis < 0 ? -direction : voxc_scene_normal(hit);
  vec3 colour = (lacks ? UNKNOWN : colour_of_word(hit.colour)) * (0.9 + 0.2 * face.y - 0.1 * abs(face.x));
  uint first = floatBitsToUint(hit.t) >> 12 << 12 | (hit.axis < 0 ? 6u : uint(2 * hit.axis + max(hit.side, 0))) << 9;
  after_sun = found || lacks ? uvec4(floatBitsToUint(colour), first) : uvec4(0u);
  told = lacks ? page_told : page_told < WAITS ? page_told : NO_PAGE;
}
