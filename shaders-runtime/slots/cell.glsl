// Slots of this kind report no empty region: a gap is the cell alone.
INLINE uint look_up_level(const Ray ray, uint grid, ivec3 cell, inout Gap gap) { return cell_level(grid, cell); }
