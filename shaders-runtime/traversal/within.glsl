// Whether a traversal is still in the sub-volume in which it began.
bool within_level(ivec3 begin, ivec3 cell) {
  return LEVEL_FIRST ? is_in_volume(cell) : is_same_cube(begin, cell, LEVEL_LOG2_SIDE);
}
