// The voxel around a cell, from this grid down; 0, and what is empty there, if there is none.
uint locate_level_${N}(const Ray ray, uint grid, ivec3 cell, inout Gap gap) {
%if octants
  uint reach;
  uint value = cell_level_${N}(grid, cell >> LEVEL_${N}_LOG2_CELL, octant_of(ray), reach);
  gap = Gap(LEVEL_${N}_LOG2_CELL, int(reach));
%else
%if distances
  uint reach;
  uint value = cell_level_${N}(grid, cell >> LEVEL_${N}_LOG2_CELL, reach);
  int count = int((reach + 2u) / 3u); // The largest cube ahead whose cells are all nearer.
%if first
%else
  // But not out of the sub-volume: of its cells alone the distance speaks.
  ivec3 size = ivec3(1) << LEVEL_${N}_LOG2_SIZE;
  ivec3 at = (cell >> LEVEL_${N}_LOG2_CELL) & (size - 1);
  ivec3 room = (ray.ahead & (size - at)) | (~ray.ahead & (at + 1));
  count = min(count, min(min(room.x, room.y), room.z));
%end
  gap = Gap(LEVEL_${N}_LOG2_CELL, count);
%else
%if tells-around
  int around;
  uint value = cell_level_${N}(ray, grid, cell >> LEVEL_${N}_LOG2_CELL, around);
%else
%if probes
  bool known;
  uint value = cell_level_${N}(grid, cell >> LEVEL_${N}_LOG2_CELL, known);
%else
  uint value = cell_level_${N}(grid, cell >> LEVEL_${N}_LOG2_CELL);
%end
%end
  gap = Gap(LEVEL_${N}_LOG2_CELL${plus-around}, ${known});
%end
%end
%if last
  return value;
%else
  return value == 0u ? 0u : locate_${NEXT}(ray, value, cell, gap);
%end
}
