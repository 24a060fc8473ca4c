// What leads to a sub-volume of voxels of one value; 0 of empty ones.
uint32_t fill_level_${N}(Edit &edit, uint32_t value);
uint32_t filled_level_${N}(Edit &edit, uint32_t value) { return edit.filled(${N}, value, fill_level_${N}); }
