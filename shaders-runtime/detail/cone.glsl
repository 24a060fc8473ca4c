// Deliberate approximation: a ray is a cone, and a traversal stops at what looks smaller than the cone is wide, with the
// colour, if that is asked, of one voxel from inside.

// How far the traversal's cell is from the ray's origin, in voxels. That of the cell, not of the point where it is entered,
// so that it does not matter where the traversal counts from.
float travelled(const Ray ray, const Traversal traversal) {
  return length(vec3(traversal.cell) + 0.5f - uintBitsToFloat(ray.given_origin));
}

// log2 of the side of the largest cubes that look small at the traversal's cell; -1 if voxels do not.
int small_height(const Ray ray, const Traversal traversal) {
  float width = SPREAD * travelled(ray, traversal);
  // The exponent of the float below: a cube as wide as the cone is not small. No number is not above 1 either.
  return width > 1.0 ? int((floatBitsToUint(width) - 1u) >> 23) - 127 : -1;
}

// Ends the traversal in its cell. A voxel is missing only where the device cut its search short: the traversal then stays in its
// cell, to be resumed.
bool stop_with(inout Traversal traversal, uint voxel) {
  traversal.voxel = voxel;
  return voxel != 0u;
}

uint sample_voxel(uint voxel) { return voxel; }
