// A single voxel: the walk has arrived.
bool intersect_voxel(const Ray ray, inout Walk walk, uint rgba) {
  walk.rgba = rgba;
  return true;
}
