// Pixels that wait tell of the page that they lack, others of one that they have used.
layout(location = 0) out uvec4 first_target;
layout(location = 1) out uvec4 second_target;
layout(location = 2) out uint told;

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  if (given.is_again != 0 && stays(here)) {
    first_target = texelFetch(before_sun, here, 0);
    second_target = texelFetch(before_sky, here, 0);
    told = told_again(here);
    return;
  }
  begin_loads(uvec2(here), uint(given.number));
  Texels texels = texels_at(here);
  first_target = texels.first;
  second_target = texels.second;
  told = lacks_page() || page_told < WAITS ? page_told : NO_PAGE;
}
