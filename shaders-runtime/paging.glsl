// Words by their pages.

// An entry of the page table is the page's slot and two bits.
const uint TOUCHED = 0x80000000u; // It was looked for.
const uint ABSENT = 0x40000000u;  // It is not here, and its slot is that of zeros.
const uint SLOT_BITS = 0x3fffffffu;

// A word of a page. Where the page is absent it is 0, and from then on all words are: the traversal has to wait, and asks for no
// more than what it surely needs. Beyond the volume words are 0 too, wherever a damaged one may lead.
uint load_from_page(uint page, uint at) {
  if (COUNT_WORDS)
    words_read++;
  page = lacks_page ? PAGES : min(page, PAGES);
  uint entry = page_table[page];
  if ((entry & TOUCHED) == 0u)
    page_table[page] = entry | TOUCHED; // All that come here write the same.
  lacks_page = lacks_page || (entry & ABSENT) != 0u;
  return words[((entry & SLOT_BITS) << LOG2_PAGE_WORDS) + at];
}

// A word of what begins at a granule.
uint load_word(uint granule, uint offset) {
  uint log2_page = LOG2_PAGE_WORDS - uint(LOG2_GRANULE); // In granules.
  uint word = ((granule & ((1u << log2_page) - 1u)) << LOG2_GRANULE) + offset;
  return load_from_page((granule >> log2_page) + (word >> LOG2_PAGE_WORDS), word & ((1u << LOG2_PAGE_WORDS) - 1u));
}

uint load_word(uint place) {
  if (GRANULES)
    return load_word(place, 0u);
  return load_from_page(place >> LOG2_PAGE_WORDS, place & ((1u << LOG2_PAGE_WORDS) - 1u));
}
