// Of each square of four by four pixels up to four pages that are lacking, or else some that were used.
layout(location = 0) out uvec4 pages;

const uint WAITS = 0x80000000u, NO_PAGE = 0x7fffffffu;

void main() {
  ivec2 size = textureSize(told, 0), low = ivec2(gl_FragCoord.xy) * 4;
  uvec4 found = uvec4(NO_PAGE);
  int count = 0;
  for (int i = 0; i < 32; i++) {
    int k = (i + given.number) & 15;
    ivec2 at = low + ivec2(k & 3, k >> 2);
    if (count > 3 || any(greaterThanEqual(at, size)))
      continue;
    uint page = texelFetch(told, at, 0).x;
    uint place = uint(at.y * size.x + at.x);
    bool is_new = page != NO_PAGE && all(notEqual(found, uvec4(page))) && (page < WAITS) == (i >= 16);
    if (is_new && (page < WAITS || (place >= given.turn.x && place < given.turn.y)))
      found[count++] = page;
  }
  pages = found;
}
