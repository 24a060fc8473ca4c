uint raw_value(uint grid, ivec3 cell, ivec3 log2_size) { return raw_cell(grid, cell, log2_size); }
