// One more sample of each pixel: a ray from the eye, and from what it meets one to the sun and one to the sky; or a sketch, the first
// of these alone. A pixel that lacks a page of the volume is left as it was, and waits.
const int SUN = 1;
const int SKY = 2;
const int DONE = 3;
const float ABOVE_CUT = 0.01; // So many voxels above a cut rays to the light begin.

// In a square of four by four pixels all rays to the sky go elsewhere.
vec2 numbers_of(ivec2 pixel) {
  int x = pixel.x;
  int y = pixel.y;
  int order = ((x ^ y) & 1) << 3 | (y & 1) << 2 | ((x ^ y) & 2) | (y & 2) >> 1;
  return fract(given.numbers + float(order) * vec2(0.7548776662, 0.5698402910));
}

// The bits of the sun's light, and in 9 bits how many rays have hit, in 3 the first one's face, in 20 its t; then those of the light of
// a sky that nothing hides, and of how much of it is seen. This sample's, together with those before it.
Texels gathered(ivec2 at, bool lacks, vec3 by_sun, vec4 by_sky, uint first) {
  uvec4 sun_before = texelFetch(before_sun, at, 0);
  if (given.is_further == 0)
    return Texels(uvec4(floatBitsToUint(by_sun), first), floatBitsToUint(by_sky));
  if (lacks || given.is_after_sketch == 0) {
    by_sun += uintBitsToFloat(sun_before.xyz);
    by_sky += uintBitsToFloat(texelFetch(before_sky, at, 0));
  }
  first = sun_before.w == 0u ? first : sun_before.w + (first & 1u);
  return Texels(uvec4(floatBitsToUint(by_sun), first), floatBitsToUint(by_sky));
}

Texels texels_at(ivec2 here) {
  ivec2 pixel = ivec2(here.x, given.size.y - 1 - here.y);
  vec2 at = (vec2(pixel) + given.place) / vec2(given.size) * 2.0 - 1.0;
  // Rays are in voxels; angles, t and light in spaced space.
  at.y = -at.y;
  vec3 origin = (given.eye + aside(at)) / SPACING;
  vec3 direction = way(at) / SPACING;
  bool is_sketch = given.is_sketch != 0;
  vec3 by_sun = vec3(0.0);
  vec4 by_sky = vec4(0.0);
  uint first = 0u; // Face and t.
  vec3 colour, normal, point, start, face, before_face, across_voxels;
  float room = 0.0; // Above a smooth surface, so many voxels, its steps hide nothing of it any more.
  bool lacks = false;
  for (int task = 0; task < DONE;) {
    voxc_scene_Hit hit;
    bool found = seen_first(origin, direction, task > 0, hit);
    lacks = lacks_page();
    if (lacks) {
      first = 0u;
      by_sun = vec3(0.0);
      break;
    }
    if (task == 0) {
      task = DONE;
      if (found) {
        uint side = hit.axis < 0 ? 6u : uint(2 * hit.axis + max(hit.side, 0));
        first = floatBitsToUint(hit.t) >> 12 << 12 | side << 9 | uint(!is_sketch);
        colour = colour_of_word(hit.colour);
        face = hit.axis < 0 ? -normalize(direction * SPACING) : voxc_scene_normal(hit);
        normal = face;
        point = origin + hit.t * direction;
        before_face = voxc_scene_outside(origin, direction, hit);
        start = before_face;
        if (lies_at_cut(hit.t)) {
          face = normalize(cut_normal / SPACING);
          normal = face;
          before_face = origin + cut_t * direction + ABOVE_CUT * cut_normal;
          start = before_face;
        } else if (given.is_smooth != 0 && !is_sketch && hit.axis >= 0) {
          normal = surface_normal(here, hit.voxel, hit.t, direction);
        }
        if (normal == vec3(0.0)) {
          normal = face;
        } else if (normal != face) {
          room = 2.0;
          across_voxels = normal;
          start = point + room * across_voxels;
          normal = normalize(normal / SPACING);
        }
        task = is_sketch ? DONE : dot(normal, given.sun) > 0.0 ? SUN : SKY;
      }
    } else if (found && hit.axis < 0 && room > 0.0) {
      // There is no room for that: nearer, or as the face is.
      room -= 1.0;
      normal = room > 0.0 ? normal : face;
      start = room > 0.0 ? point + room * across_voxels : before_face;
      by_sun = vec3(0.0);
      task = dot(normal, given.sun) > 0.0 ? SUN : SKY;
    } else if (task == SUN) {
      by_sun = found ? vec3(0.0) : colour * SUN_LIGHT * dot(normal, given.sun);
      task = SKY;
    } else {
      by_sky = vec4(colour * sky_light(normal), found ? PASSED_ON * hit.t / (hit.t + given.open_scale) : 1.0);
      task = DONE;
    }
    origin = start;
    direction = (task == SUN ? given.sun : sky_direction(normal, numbers_of(pixel))) / SPACING;
  }
  return gathered(here, lacks, by_sun, by_sky, first);
}
