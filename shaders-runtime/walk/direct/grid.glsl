// The voxel around a cell, from this grid down; 0, and what is empty there, if there is none.
uint locate_level_${N}(const Ray ray, uint grid, ivec3 cell, inout Gap gap) {
  gap = Gap(LEVEL_${N}_LOG2_CELL, 1);
  uint value = cell_level_${N}(ray, grid, cell >> LEVEL_${N}_LOG2_CELL, gap);
%if marches
  gap.count = (gap.count + 2) / 3; // The largest cube ahead whose cells are all nearer than the distance.
%if first
%else
  // But not out of the sub-volume: of its cells alone the distance speaks.
  ivec3 size = ivec3(1) << LEVEL_${N}_LOG2_SIZE;
  ivec3 at = (cell >> LEVEL_${N}_LOG2_CELL) & (size - 1);
  ivec3 room = (ray.ahead & (size - at)) | (~ray.ahead & (at + 1));
  gap.count = min(gap.count, min(min(room.x, room.y), room.z));
%end
%end
%if last
  return value;
%else
  return value == 0u ? 0u : locate_${NEXT}(ray, value, cell, gap);
%end
}
