// Rays tell of pages behind their hits.
layout(location = 0) out uvec4 first_target;
layout(location = 1) out uvec4 second_target;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  begin_loads(uvec2(at), 0u);
  Texels texels = texels_at(at);
  first_target = texels.first;
  second_target = uvec4(texels.second.xyz, page_told);
}
