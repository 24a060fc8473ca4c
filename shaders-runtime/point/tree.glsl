// Whether there is a voxel, in this tree.
bool is_voxel_level(uint root, ivec3 voxel) {
  ivec3 at = voxel >> LEVEL_LOG2_CELL;
  uint node = root;
  bool leaf = false;
%if wide
  int around = 0;
%end
${LAYERS_DOWN}  // A leaf, or nothing.
%if last
  return node != 0u;
%else
  return node != 0u && is_voxel_next(${leaf-node}, voxel);
%end
}
