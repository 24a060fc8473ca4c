// The voxel around a cell, from this tree down; 0, and ${what-is-empty}, if there is none.
uint locate_level(const Ray ray, uint root, ivec3 cell, inout Gap gap${and-faces}) {
  ivec3 at = cell >> LEVEL_LOG2_CELL;
  uint node = root;
  bool leaf = false;
%if wide
  int around = 0;
%end
${LAYERS_DOWN}  // A leaf, or nothing.
%if tells-faces
  if (node == 0u)
    face = real3(faces_ahead(ray, cell, gap));
%end
%if last
  return ${leaf-or-0};
%else
  return node == 0u ? 0u : locate_next(ray, ${leaf-node}, cell, gap${and-face});
%end
}
