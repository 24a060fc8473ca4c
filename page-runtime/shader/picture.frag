// One more sample of each pixel: a ray from the eye, and from what it meets one to the sun and one to the sky; or a sketch, the first
// of these alone. A pixel that lacks a page of the volume is left as it was, and waits.
uniform highp usampler2D before_sky;
uniform bool is_sketch;  // No light yet: only where surfaces are.
uniform bool is_further; // There are samples, or a sketch, before this one.
uniform bool is_after_sketch; // Whose light does not count.
uniform bool is_smooth;  // Surfaces have the direction of their neighbourhood.
uniform vec2 place;      // Where in a pixel.
uniform vec2 numbers;    // For directions to the sky.
uniform vec3 sun;
uniform float open_scale;
// The bits of the sun's light, and in 9 bits how many rays have hit, in 3 the first one's face, in 20 its t.
layout(location = 0) out uvec4 after_sun;
// The bits of the light of a sky that nothing hides, and of how much of it is seen.
layout(location = 1) out uvec4 after_sky;

#ifdef PAGED
uniform highp usampler2D before_told;
uniform bool is_again; // As in sketch.frag.
uniform uvec2 turn;
uniform int number;
layout(location = 2) out uint told;
#endif

const int SUN = 1, SKY = 2, DONE = 3;
const float ABOVE_CUT = 0.01; // So many voxels above a cut rays to the light begin.

// In a square of four by four pixels all rays to the sky go elsewhere.
vec2 numbers_of(ivec2 pixel) {
  int x = pixel.x, y = pixel.y;
  int order = ((x ^ y) & 1) << 3 | (y & 1) << 2 | ((x ^ y) & 2) | (y & 2) >> 1;
  return fract(numbers + float(order) * vec2(0.7548776662, 0.5698402910));
}

void main() {
  bool lacks = false;
#ifdef PAGED
  ivec2 here = ivec2(gl_FragCoord.xy);
  if (is_again && stays(here, size.x, before_told, turn)) {
    after_sun = texelFetch(before_sun, here, 0);
    after_sky = texelFetch(before_sky, here, 0);
    told = told_again(here, before_told);
    return;
  }
  begin_loads(uvec2(here), uint(number));
#endif
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  pixel.y = size.y - 1 - pixel.y;
  vec2 at = (vec2(pixel) + place) / vec2(size) * 2.0 - 1.0;
  // Rays are in voxels; angles, t and light in spaced space.
  at.y = -at.y;
  vec3 origin = (eye + aside(at)) / SPACING;
  vec3 direction = way(at) / SPACING;
  vec3 by_sun = vec3(0.0);
  vec4 by_sky = vec4(0.0);
  uint first = 0u; // Face and t.
  vec3 colour, normal, point, start, face, before_face, across_voxels;
  float room = 0.0; // Above a smooth surface, so many voxels, its steps hide nothing of it any more.
  for (int task = 0; task < DONE;) {
    voxc_scene_Hit hit;
    bool found = seen_first(origin, direction, task > 0, hit);
#ifdef PAGED
    lacks = voxc_scene_lacks_page;
    if (lacks) {
      first = 0u;
      by_sun = vec3(0.0);
      break;
    }
#endif
    if (task == 0) {
      task = DONE;
      if (found) {
        first = floatBitsToUint(hit.t) >> 12 << 12 | (hit.axis < 0 ? 6u : uint(2 * hit.axis + max(hit.side, 0))) << 9 | uint(!is_sketch);
        colour = colour_of_word(hit.colour);
        normal = face = hit.axis < 0 ? -normalize(direction * SPACING) : voxc_scene_normal(hit);
        point = origin + hit.t * direction;
        start = before_face = voxc_scene_outside(origin, direction, hit);
        if (lies_at_cut(hit.t)) {
          normal = face = normalize(cut_normal / SPACING);
          start = before_face = origin + cut_t * direction + ABOVE_CUT * cut_normal;
        } else if (is_smooth && !is_sketch && hit.axis >= 0) {
          normal = surface_normal(ivec2(gl_FragCoord.xy), hit.voxel, hit.t, direction);
        }
        if (normal == vec3(0.0)) {
          normal = face;
        } else if (normal != face) {
          room = 2.0;
          across_voxels = normal;
          start = point + room * across_voxels;
          normal = normalize(normal / SPACING);
        }
        task = is_sketch ? DONE : dot(normal, sun) > 0.0 ? SUN : SKY;
      }
    } else if (found && hit.axis < 0 && room > 0.0) {
      // There is no room for that: nearer, or as the face is.
      room -= 1.0;
      normal = room > 0.0 ? normal : face;
      start = room > 0.0 ? point + room * across_voxels : before_face;
      by_sun = vec3(0.0);
      task = dot(normal, sun) > 0.0 ? SUN : SKY;
    } else if (task == SUN) {
      by_sun = found ? vec3(0.0) : colour * SUN_LIGHT * dot(normal, sun);
      task = SKY;
    } else {
      by_sky = vec4(colour * sky_light(normal), found ? PASSED_ON * hit.t / (hit.t + open_scale) : 1.0);
      task = DONE;
    }
    origin = start;
    direction = (task == SUN ? sun : sky_direction(normal, numbers_of(pixel))) / SPACING;
  }
  if (is_further) {
    uvec4 sun_before = texelFetch(before_sun, ivec2(gl_FragCoord.xy), 0);
    if (lacks || !is_after_sketch) {
      by_sun += uintBitsToFloat(sun_before.xyz);
      by_sky += uintBitsToFloat(texelFetch(before_sky, ivec2(gl_FragCoord.xy), 0));
    }
    first = sun_before.w == 0u ? first : sun_before.w + (first & 1u);
  }
  after_sun = uvec4(floatBitsToUint(by_sun), first);
  after_sky = floatBitsToUint(by_sky);
#ifdef PAGED
  told = lacks ? page_told : page_told < WAITS ? page_told : NO_PAGE;
#endif
}
