// ---- The format: G(9) ----

// Which child of a node a place lies in, counted in children.
int voxc_g9_child_index(ivec3 place) {
  ivec3 bits = place & 1;
  return bits.x | bits.y << 1 | bits.z << 2;
}

// Level 1: svdag, 512 x 512 x 512 cells of 1 voxel a side.
const int voxc_g9_LEVEL_1_DEPTH = 9;
const int voxc_g9_LEVEL_1_LOG2_CELL = 0;

// A node is [masks, references to the children that are neither empty nor leaves...]. The highest three bits of a
// reference say across which axes the node there is reflected, x lowest; on the way down, reflections add up. Gives the
// child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
uint voxc_g9_child_level_1(VOXC_VOLUME volume, uint node, ivec3 cell, int height, out bool leaf) {
  uint begin = node & 0x1fffffffu;
  int child = voxc_g9_child_index(cell >> height) ^ int(node >> 29);
  uint masks = voxc_g9_load_word(volume, begin);
  leaf = (masks >> (8 + child) & 1u) != 0u;
  if ((masks >> child & 1u) == 0u)
    return 0u;
  if (leaf)
    return node; // All leaves have the same value.
  masks &= ~(masks >> 8);
  uint slot = uint(bitCount(masks & ((1u << child) - 1u)));
  return voxc_g9_load_word(volume, begin + 1u + slot) ^ (node & 0xe0000000u);
}

// path[i] is the node i layers above the cells around the traversal's cell: a step climbs only to the ancestor of the
// old cell and the new.
bool voxc_g9_intersect_level_1(VOXC_VOLUME volume, const voxc_g9_Ray ray, inout voxc_g9_Traversal traversal,
    uint root) {
  uint path[voxc_g9_LEVEL_1_DEPTH + 1];
  path[voxc_g9_LEVEL_1_DEPTH] = root;
  int top = voxc_g9_LEVEL_1_DEPTH;
  for (;;) {
    ivec3 cell = traversal.cell >> voxc_g9_LEVEL_1_LOG2_CELL;
    uint node = path[top];
    int layer = top;
    bool leaf = false;
    while (node != 0u && !leaf) {
      path[layer] = node;
      layer--;
      node = voxc_g9_child_level_1(volume, node, cell, layer, leaf);
    }
    ivec3 before = traversal.cell;
    if (node == 0u)
      voxc_g9_step_over(ray, traversal, voxc_g9_LEVEL_1_LOG2_CELL + layer);
    else if (leaf && voxc_g9_intersect_voxel())
      return true;

    if (!voxc_g9_goes_on(traversal))
      return false;
    ivec3 changed = before ^ traversal.cell;
    int highest = findMSB(uint(changed.x | changed.y | changed.z));
    top = max(layer, highest - voxc_g9_LEVEL_1_LOG2_CELL) + 1;
  }
}

// What a voxel is: here nothing but that it is there, which is shown in white.
uint voxc_g9_colour_of() { return 0xffffffffu; }

