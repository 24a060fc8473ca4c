// A single voxel: the walk has arrived.
bool intersect_voxel(const Ray ray, inout Walk walk, uint rgba, ivec3 low) {
  walk.rgba = rgba;
  return true;
}
