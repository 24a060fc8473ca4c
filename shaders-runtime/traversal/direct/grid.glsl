// The faces ahead of what a mask may tell to be empty. They are made before it is known which of these it is, since the mask
// comes late: to choose is then all that is left to do.
real3 faces_level(const Ray ray, ivec3 cell, const EmptySpan span) {
  real3 of_cell = real3(faces_ahead(ray, cell, EmptySpan(LEVEL_LOG2_CELL, 1)));
  real3 of_group = real3(faces_ahead(ray, cell, EmptySpan(LEVEL_LOG2_CELL + 1, 1)));
  if (LEVEL_TELLS_HALF)
    return span.log2_side == LEVEL_LOG2_CELL ? of_cell : of_group;
  real3 of_grid = real3(faces_ahead(ray, cell, EmptySpan(LEVEL_LOG2_CELL + 2, 1)));
  return span.log2_side == LEVEL_LOG2_CELL ? of_cell : span.log2_side == LEVEL_LOG2_CELL + 1 ? of_group : of_grid;
}

// The voxel around a cell, from this grid down; 0, and what is empty there with its faces ahead, if there is none.
uint locate_level(const Ray ray, uint grid, ivec3 cell, inout EmptySpan span, inout real3 face) {
  span = EmptySpan(LEVEL_LOG2_CELL, 1);
  uint value = look_up_level(ray, grid, cell >> LEVEL_LOG2_CELL, span);
  if (LEVEL_MARCHES)
    span.count = (span.count + 2) / 3; // The largest cube ahead whose cells are all nearer than the distance.
  if (LEVEL_MARCHES && !LEVEL_FIRST) {
    // But not out of the sub-volume: of its cells alone the distance speaks.
    ivec3 size = ivec3(1) << LEVEL_LOG2_SIZE;
    ivec3 at = (cell >> LEVEL_LOG2_CELL) & (size - 1);
    ivec3 room = (ray.ahead & (size - at)) | (~ray.ahead & (at + 1));
    span.count = min(span.count, min(min(room.x, room.y), room.z));
  }
  if (REPORTS_FACES && value == 0u)
    face = LEVEL_CHOOSES_FACES ? faces_level(ray, cell, span) : real3(faces_ahead(ray, cell, span));
  return LEVEL_LAST ? value : value == 0u ? 0u : locate_next(ray, value, cell, span, face);
}
