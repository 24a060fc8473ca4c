// The hits of rays: two texels a ray are its origin and its direction, as bits, each with a bound behind it.
uniform highp usampler2D rays;
layout(location = 0) out uvec4 place;
layout(location = 1) out uvec4 rest;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 from = uintBitsToFloat(texelFetch(rays, ivec2(2 * at.x, at.y), 0));
  vec4 direction = uintBitsToFloat(texelFetch(rays, ivec2(2 * at.x + 1, at.y), 0));
#ifdef PAGED
  begin_loads(uvec2(at), 0u);
#endif
  voxc_scene_Hit hit;
  bool found = seen_between(from.xyz, direction.xyz, from.w, direction.w, hit);
  place = uvec4(uvec3(hit.voxel), floatBitsToUint(hit.t));
  uint face = !found ? 0u : hit.axis < 0 ? 6u : uint(2 * hit.axis + (hit.side > 0 ? 1 : 0));
  rest = uvec4(hit.colour, face, uint(found), 0u);
#ifdef PAGED
  rest.w = page_told;
#endif
}
