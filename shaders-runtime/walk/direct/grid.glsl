%if tells-faces
%if chooses-faces
// The faces ahead of what a mask may tell to be empty. They are made before it is known which of these it is, since the mask
// comes late: to choose is then all that is left to do.
real3 faces_level(const Ray ray, ivec3 cell, const Gap gap) {
  real3 of_cell = real3(faces_ahead(ray, cell, Gap(LEVEL_LOG2_CELL, 1)));
  real3 of_group = real3(faces_ahead(ray, cell, Gap(LEVEL_LOG2_CELL + 1, 1)));
%if tells-half
  return gap.log2_side == LEVEL_LOG2_CELL ? of_cell : of_group;
%else
  real3 of_grid = real3(faces_ahead(ray, cell, Gap(LEVEL_LOG2_CELL + 2, 1)));
  return gap.log2_side == LEVEL_LOG2_CELL ? of_cell : gap.log2_side == LEVEL_LOG2_CELL + 1 ? of_group : of_grid;
%end
}

%end
%end
// The voxel around a cell, from this grid down; 0, and ${what-is-empty}, if there is none.
uint locate_level(const Ray ray, uint grid, ivec3 cell, inout Gap gap${and-faces}) {
  gap = Gap(LEVEL_LOG2_CELL, 1);
  uint value = cell_level(${cell-ray,}grid, cell >> LEVEL_LOG2_CELL${cell,gap});
%if marches
  gap.count = (gap.count + 2) / 3; // The largest cube ahead whose cells are all nearer than the distance.
%if first
%else
  // But not out of the sub-volume: of its cells alone the distance speaks.
  ivec3 size = ivec3(1) << LEVEL_LOG2_SIZE;
  ivec3 at = (cell >> LEVEL_LOG2_CELL) & (size - 1);
  ivec3 room = (ray.ahead & (size - at)) | (~ray.ahead & (at + 1));
  gap.count = min(gap.count, min(min(room.x, room.y), room.z));
%end
%end
%if tells-faces
  if (value == 0u)
%if chooses-faces
    face = faces_level(ray, cell, gap);
%else
    face = real3(faces_ahead(ray, cell, gap));
%end
%end
%if last
  return value;
%else
  return value == 0u ? 0u : locate_next(ray, value, cell, gap${and-face});
%end
}
