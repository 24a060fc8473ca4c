// Slots of this kind report no empty region: an empty span is the cell alone.
INLINE uint look_up_level(const Ray ray, uint grid, ivec3 cell, inout EmptySpan span) { return cell_level(grid, cell); }
