// The values of voxels, by rank. Word 1 of the volume says where they begin: with how many colours there are (the lowest 24
// bits) and the bits of an entry; then the colours; an entry for each block of 128; the blocks. An entry tells from there on
// where the block is or, if all of its voxels have one colour, that colour. A block is
//   the least index; the bits of an item; MASK; BEGINS; how many items the palette has, or how many runs BEGINS tell;
//   with MASK, 128 bits, set where a voxel is not like the one before it;
//   with BEGINS, 7 bits for each run but the first, the voxel that begins it;
//   the items, of the palette, of the runs, or of all voxels: indices above the least;
//   with a palette, for each voxel, or run of MASK, the number of its item.
const uint LOG2_BLOCK = 7u;
const uint ITEM_BITS_SHIFT = 16u;
const uint MASK = 1u << 21;
const uint BEGINS = 1u << 22;
const uint COUNT_SHIFT = 24u;
const uint MASK_WORDS = 4u;
const uint BEGIN_BITS = 7u;
const uint COLOURS = 0xffffffu; // How many there are, in the first word of all.
const uint ENTRY_BITS_SHIFT = 24u;

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

// The run that lies `step` on from one, of `runs` whose begins stand at a word, if it begins at voxel i or before; else the
// run itself.
uint run_ahead(uint section, uint place, uint run, uint step, uint runs, uint i) {
  uint next = run + step;
  if (next >= runs)
    return run;
  return load_field_at(section, place, (next - 1u) * BEGIN_BITS, BEGIN_BITS) <= i ? next : run;
}

// The run of voxel i, of 32 at most.
uint run_of(uint section, uint place, uint runs, uint i) {
  uint run = run_ahead(section, place, 0u, 16u, runs, i);
  run = run_ahead(section, place, run, 8u, runs, i);
  run = run_ahead(section, place, run, 4u, runs, i);
  run = run_ahead(section, place, run, 2u, runs, i);
  return run_ahead(section, place, run, 1u, runs, i);
}

// The index of voxel i of a block.
uint index_in_block(uint section, uint block, uint i) {
  uint head = load_word_from(section, block);
  uint bits = head >> ITEM_BITS_SHIFT & 31u;
  uint count = head >> COUNT_SHIFT;
  uint fields = block + 1u;
  uint items = 0u; // The first bit of the items.
  if ((head & MASK) != 0u) {
    i = runs_until(section, fields, i) - 1u;
    fields += MASK_WORDS;
  }
  if ((head & BEGINS) != 0u) {
    i = run_of(section, fields, count, i);
    items = (count - 1u) * BEGIN_BITS;
  } else if (count != 0u) {
    uint number_bits = uint(findMSB(count - 1u) + 1);
    i = load_field_at(section, fields, count * bits + i * number_bits, number_bits);
  }
  return (head & 0xffffu) + load_field_at(section, fields, items + i * bits, bits);
}

// The value of the voxel of a rank.
uint value_of_rank(uint rank) {
  uint section = load_word_at(0u, 1u);
  uint head = load_word_at(section, 0u);
  uint colours = head & COLOURS;
  uint entry = load_field(section, place_of_word(section, 1u + colours), rank >> LOG2_BLOCK, head >> ENTRY_BITS_SHIFT);
  if (entry > colours)
    entry = 1u + index_in_block(section, place_of_word(section, entry), rank & ((1u << LOG2_BLOCK) - 1u));
  return load_word_at(section, entry);
}
