// The value of the cell that is not empty after so many others.
uint value_of_slot_level(uint grid, uint slot) {
  uint number = load_field(grid, place_of_word(grid, LEVEL_HEAD_WORDS), slot, LEVEL_POINTER_BITS);
  return LEVEL_LEADS_BY_NUMBER ? number : load_word(LEVEL_ARRAY_HEAD) + 2u * number;
}
