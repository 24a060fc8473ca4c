%if alike
%else
// The value of the cell that is not empty after so many others.
uint value_of_slot_level(uint grid, uint slot) {
%if leads-by-number
  return load_field(grid + ${head-words}u, slot, ${pointer-bits}u);
%else
  return load_word(${array-head}u) + 2u * load_field(grid + ${head-words}u, slot, ${pointer-bits}u);
%end
}

%end
