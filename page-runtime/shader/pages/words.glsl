// The words of the volume in slots of a page each, 4096 words a row; the slot of each page, if it is here, in a table.
const uint ABSENT = 0xffffffffu;
const uint WAITS = 0x80000000u;   // Above the number of a page: it is lacking.
const uint NO_PAGE = 0x7fffffffu;
uint page_told = NO_PAGE; // One that was used, or the one that is lacking.
uint loads = 0u;          // So far, from a number that differs from pixel to pixel.
uint told_of = 15u;       // Of so many loads one is told; a power of two less one.

uint word_in(highp usampler2D texture_of_words, uint index) {
  return texelFetch(texture_of_words, ivec2(int(index & 4095u), int(index >> 12)), 0).x;
}

// Pixels tell of other loads, so that all of them tell of all pages.
void begin_loads(uvec2 pixel, uint number) {
  uint noise = (pixel.x * 0x9e3779b1u ^ pixel.y * 0x85ebca77u) + number * 0xc2b2ae3du;
  noise = (noise ^ noise >> 15) * 0x9e3779b1u;
  loads = noise >> 8;
  told_of = (8u << 2u * (noise & 3u)) - 1u;
}

// Beyond the volume words are 0.
bool find_word(uint index, out uint word) {
  uint page = index >> LOG2_PAGE_WORDS;
  uint slot = page < PAGES ? word_in(page_table, page) : 0u;
  bool is_here = slot != ABSENT;
  word = is_here && page < PAGES ? word_in(words, (slot << LOG2_PAGE_WORDS) + (index & ((1u << LOG2_PAGE_WORDS) - 1u))) : 0u;
  page_told = !is_here ? page | WAITS : (loads++ & told_of) == 0u ? page : page_told;
  return is_here;
}

// Whether a pixel stays as it is while others that wait are traced: it does not wait, or its turn has not come.
bool stays(ivec2 at) {
  uint place = uint(at.y * given.size.x + at.x);
  return texelFetch(before_told, at, 0).x < WAITS || place < given.turn.x || place >= given.turn.y;
}

// What it tells then: that it waits still.
uint told_again(ivec2 at) {
  uint before = texelFetch(before_told, at, 0).x;
  return before < WAITS ? NO_PAGE : before;
}

#define VOXC_VOLUME int
#define VOXC_FIND(volume, index, word) find_word(index, word)
