// A word was looked for that is not here. From then on all words are 0: what would be asked for next might follow from it.
bool lacks_page = false;

// A word of what begins at a granule.
uint load_word(uint granule, uint offset) {
  if (!PAGED)
    return VOXC_LOAD(volume, (VOXC_INDEX(granule) << LOG2_GRANULE) + offset);
  uint word = 0u;
  lacks_page = lacks_page || !VOXC_FIND(volume, (VOXC_INDEX(granule) << LOG2_GRANULE) + offset, word);
  return lacks_page ? 0u : word;
}

uint load_word(uint place) {
  if (GRANULES)
    return load_word(place, 0u);
  if (!PAGED)
    return VOXC_LOAD(volume, place);
  uint word = 0u;
  lacks_page = lacks_page || !VOXC_FIND(volume, place, word);
  return lacks_page ? 0u : word;
}
