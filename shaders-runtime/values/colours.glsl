// The values of voxels, by rank. Word 1 of the volume says where they begin: with a word for each block of 128, where that
// begins, then the blocks. A block is
//   the least of each channel;
//   4 bits a channel, how many bits it takes; DIFFERENCES; RUNS; the bits of an index; the word where the items begin;
//   with RUNS, 128 bits, set where a value is not that before it;
//   for each value, or run, the index of its item, if that has bits; the items.
const uint LOG2_BLOCK = 7u;
const uint DIFFERENCES = 1u << 16; // R and B are told as their differences from G.
const uint RUNS = 1u << 17;
const uint INDEX_SHIFT = 18u;
const uint ITEMS_SHIFT = 24u;
const uint HEAD_WORDS = 2u;
const uint RUN_WORDS = 4u;

// How many of the bits at a word are set, up to bit i of the four words.
uint runs_until(uint section, uint place, uint i) {
  uint last = i >> 5;
  uint begun = 0u;
  if (last > 0u)
    begun += uint(bitCount(load_word_from(section, place)));
  if (last > 1u)
    begun += uint(bitCount(load_word_from(section, place + 1u)));
  if (last > 2u)
    begun += uint(bitCount(load_word_from(section, place + 2u)));
  return begun + uint(bitCount(load_word_from(section, place + last) & (0xffffffffu >> (31u - (i & 31u)))));
}

// A channel, whose bits begin at `shift` of an item and, in the head, 4 * channel up.
uint channel_of(uint item, uint shift, uint least, uint head, uint channel) {
  uint bits = head >> (4u * channel) & 15u;
  return (item >> shift & ((1u << bits) - 1u)) + (least >> (8u * channel)) & 255u;
}

uint value_of_item(uint item, uint least, uint head) {
  uint g_at = head & 15u;
  uint b_at = g_at + (head >> 4 & 15u);
  uint a_at = b_at + (head >> 8 & 15u);
  uint r = channel_of(item, 0u, least, head, 0u);
  uint g = channel_of(item, g_at, least, head, 1u);
  uint b = channel_of(item, b_at, least, head, 2u);
  uint a = channel_of(item, a_at, least, head, 3u);
  uint from = (head & DIFFERENCES) != 0u ? g : 0u;
  return (r + from & 255u) | g << 8 | (b + from & 255u) << 16 | a << 24;
}

// The value of the voxel of a rank.
uint value_of_rank(uint rank) {
  uint section = load_word_at(0u, 1u);
  uint block = place_of_word(section, load_word_at(section, (rank >> LOG2_BLOCK)));
  uint least = load_word_from(section, block);
  uint head = load_word_from(section, block + 1u);
  uint i = rank & ((1u << LOG2_BLOCK) - 1u);
  uint fields = block + HEAD_WORDS;
  if ((head & RUNS) != 0u) {
    i = runs_until(section, fields, i) - 1u;
    fields += RUN_WORDS;
  }
  uint index_bits = head >> INDEX_SHIFT & 15u;
  if (index_bits != 0u)
    i = load_field(section, fields, i, index_bits);
  uint bits = (head & 15u) + (head >> 4 & 15u) + (head >> 8 & 15u) + (head >> 12 & 15u);
  // Items without bits take no words, and a field is read with the word behind it: behind the last block is one word alone.
  uint items = bits != 0u ? head >> ITEMS_SHIFT : 0u;
  return value_of_item(load_field(section, block + items, i, bits), least, head);
}
