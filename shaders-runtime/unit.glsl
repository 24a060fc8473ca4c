// A single voxel: the traversal has arrived.
bool intersect_voxel(const Ray ray, inout Traversal traversal, uint voxel) {
  traversal.voxel = voxel;
  return true;
}
