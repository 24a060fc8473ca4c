// ---- The format: S(9) ----

// Which child of a node a place lies in, counted in children.
int voxc_s9_child_index(int3 place) {
  int3 bits = place & 1;
  return bits.x | bits.y << 1 | bits.z << 2;
}

// Level 1: svo, 512 x 512 x 512 cells of 1 voxel a side.
static const int voxc_s9_LEVEL_1_DEPTH = 9;
static const int voxc_s9_LEVEL_1_LOG2_CELL = 0;

// A node of an octree is [first child, masks]; its children that are not empty stand together, two words each.
// Gives the child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
uint voxc_s9_child_level_1(VOXC_VOLUME volume, uint node, int3 cell, int height, out bool leaf) {
  int child = voxc_s9_child_index(cell >> height);
  uint masks = voxc_s9_load_word(volume, node + 1u);
  leaf = (masks >> (8 + child) & 1u) != 0u;
  if ((masks >> child & 1u) == 0u)
    return 0u;
  return voxc_s9_load_word(volume, node) + 2u * uint(int(countbits(masks & ((1u << child) - 1u))));
}

// path[i] is the node i layers above the cells around the traversal's cell: a step climbs only to the ancestor of the
// old cell and the new.
bool voxc_s9_intersect_level_1(VOXC_VOLUME volume, const voxc_s9_Ray ray, inout voxc_s9_Traversal traversal,
    uint root) {
  uint path[voxc_s9_LEVEL_1_DEPTH + 1];
  path[voxc_s9_LEVEL_1_DEPTH] = root;
  int top = voxc_s9_LEVEL_1_DEPTH;
  for (;;) {
    int3 cell = traversal.cell >> voxc_s9_LEVEL_1_LOG2_CELL;
    uint node = path[top];
    int layer = top;
    bool leaf = false;
    while (node != 0u && !leaf) {
      path[layer] = node;
      layer--;
      node = voxc_s9_child_level_1(volume, node, cell, layer, leaf);
    }
    int3 before = traversal.cell;
    if (node == 0u)
      voxc_s9_step_over(ray, traversal, voxc_s9_LEVEL_1_LOG2_CELL + layer);
    else {
      bool chosen_1;
      chosen_1 = leaf;
      if (chosen_1)
        chosen_1 = voxc_s9_intersect_voxel(traversal, node);
      if (chosen_1)
        return true;
    }

    if (!voxc_s9_goes_on(traversal))
      return false;
    int3 changed = before ^ traversal.cell;
    int highest = int(firstbithigh(uint(changed.x | changed.y | changed.z)));
    top = max(layer, highest - voxc_s9_LEVEL_1_LOG2_CELL) + 1;
  }
}

// What a voxel is: here its value is its colour.
uint voxc_s9_colour_of(VOXC_VOLUME volume, const voxc_s9_Traversal traversal) {
  return voxc_s9_load_word(volume, traversal.voxel);
}

