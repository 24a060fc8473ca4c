// The hits of rays: two texels a ray are its origin and its direction, as bits, each with a bound behind it.
Texels texels_at(ivec2 at) {
  vec4 start = uintBitsToFloat(texelFetch(rays, ivec2(2 * at.x, at.y), 0));
  vec4 direction = uintBitsToFloat(texelFetch(rays, ivec2(2 * at.x + 1, at.y), 0));
  voxc_scene_Hit hit;
  bool found = seen_between(start.xyz, direction.xyz, start.w, direction.w, hit);
  uint face = !found ? 0u : hit.axis < 0 ? 6u : uint(2 * hit.axis + max(hit.side, 0));
  return Texels(uvec4(uvec3(hit.voxel), floatBitsToUint(hit.t)), uvec4(hit.colour, face, uint(found), 0u));
}
