// The value in a slot; 0 of a cell that is empty.
uint32_t value_level_${N}(const uint32_t *slot) {
  const uint32_t word = *slot;
  return ${value-of-slot};
}

void set_value_level_${N}(uint32_t *slot, uint32_t value) {
  const PlacedCell placed = {{}, value};
  slot[0] = ${slot-of-value};
%if distances-beside
  slot[1] = 0;
%end
}
%if distances
%else

void set_empty_level_${N}(uint32_t *slot) { *slot = 0; }
%end
