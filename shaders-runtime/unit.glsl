// A single voxel: the walk has arrived.
bool intersect_voxel(const Ray ray, inout Walk walk, uint voxel) {
  walk.voxel = voxel;
  return true;
}
