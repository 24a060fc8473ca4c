layout(location = 0) out uvec4 first_target;
layout(location = 1) out uvec4 second_target;

void main() {
  Texels texels = texels_at(ivec2(gl_FragCoord.xy));
  first_target = texels.first;
  second_target = texels.second;
}
