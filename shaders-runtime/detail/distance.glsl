uint distance_value(uint grid, ivec3 cell, ivec3 log2_size) { return load_word(distance_entry(grid, cell, log2_size)); }
