// ---- The format: G(9) ----

// Which child of a node a place lies in, counted in children.
int child_index(ivec3 place) {
  ivec3 bits = place & 1;
  return bits.x | bits.y << 1 | bits.z << 2;
}

// Level 1: svdag, 512 x 512 x 512 cells of 1 voxel a side.
const int LEVEL_1_DEPTH = 9;
const int LEVEL_1_LOG2_CELL = 0;

// A node is [masks, references to the children that are neither empty nor leaves...]. The highest three bits of a
// reference say across which axes the node there is reflected, x lowest; on the way down, reflections add up. Gives the
// child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
uint child_level_1(uint node, ivec3 cell, int height, out bool leaf) {
  uint begin = node & 0x1fffffffu;
  int child = child_index(cell >> height) ^ int(node >> 29);
  uint masks = load_word(begin);
  leaf = (masks >> (8 + child) & 1u) != 0u;
  if ((masks >> child & 1u) == 0u)
    return 0u;
  if (leaf)
    return node; // All leaves have the same value.
  masks &= ~(masks >> 8);
  uint slot = uint(bitCount(masks & ((1u << child) - 1u)));
  return load_word(begin + 1u + slot) ^ (node & 0xe0000000u);
}

// path[i] is the node i layers above the cells around the traversal's cell: a step climbs only to the ancestor of the
// old cell and the new.
bool intersect_level_1(const Ray ray, inout Traversal traversal, uint root) {
  uint path[LEVEL_1_DEPTH + 1];
  path[LEVEL_1_DEPTH] = root;
  int top = LEVEL_1_DEPTH;
  for (;;) {
    // Down to the leaf, or the empty child, `layer` layers above the cells.
    count_lookup(traversal);
    ivec3 cell = traversal.cell >> LEVEL_1_LOG2_CELL;
    uint node = path[top];
    int layer = top;
    bool leaf = false;
    while (node != 0u && !leaf) {
      path[layer] = node;
      layer--;
      node = child_level_1(node, cell, layer, leaf);
    }
    ivec3 before = traversal.cell;
    if (node == 0u)
      step_over(ray, traversal, LEVEL_1_LOG2_CELL + layer);
    else if (leaf && intersect_voxel())
      return true;

    if (!goes_on(traversal))
      return false;
    ivec3 changed = before ^ traversal.cell;
    int highest = findMSB(uint(changed.x | changed.y | changed.z));
    top = max(layer, highest - LEVEL_1_LOG2_CELL) + 1;
  }
}

// What a voxel is: here nothing but that it is there, which is shown in white.
uint colour_of() { return 0xffffffffu; }

