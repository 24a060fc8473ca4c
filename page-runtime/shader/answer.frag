// The hits of rays: two texels a ray are its origin and its direction, as bits.
uniform highp usampler2D rays;
layout(location = 0) out uvec4 place;
layout(location = 1) out uvec4 rest;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec3 origin = uintBitsToFloat(texelFetch(rays, ivec2(2 * at.x, at.y), 0).xyz);
  vec3 direction = uintBitsToFloat(texelFetch(rays, ivec2(2 * at.x + 1, at.y), 0).xyz);
#ifdef PAGED
  begin_loads(uvec2(at), 0u);
#endif
  voxc_scene_Hit hit;
  bool found = voxc_scene_first(0, origin, direction, hit);
  place = uvec4(uvec3(hit.voxel), floatBitsToUint(hit.t));
  uint face = !found ? 0u : hit.axis < 0 ? 6u : uint(2 * hit.axis + (hit.side > 0 ? 1 : 0));
  rest = uvec4(hit.colour, face, uint(found), 0u);
#ifdef PAGED
  rest.w = page_told;
#endif
}
