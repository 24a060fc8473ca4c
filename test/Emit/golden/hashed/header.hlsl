// ---- The format: S(5) H(2, 2, 2) ----

// Which child of a node a place lies in, counted in children.
int voxc_s5_h2_2_2_child_index(int3 place) {
  int3 bits = place & 1;
  return bits.x | bits.y << 1 | bits.z << 2;
}

// Level 2: hash, 4 x 4 x 4 cells of 1 voxel a side.
static const int3 voxc_s5_h2_2_2_LEVEL_2_LOG2_SIZE = int3(2, 2, 2);
static const int voxc_s5_h2_2_2_LEVEL_2_LOG2_CELL = 0;
static const int voxc_s5_h2_2_2_LEVEL_2_LOG2_SIDE = 2;

// A hashed grid is [log2 of its entries, longest probe], then two words an entry: a cell's number, its value. Entries
// of value 0 are free. The value of a cell, or 0 if it is empty. The device may cut the search short.
uint voxc_s5_h2_2_2_probe_level_2(VOXC_VOLUME volume, uint table, int3 cell, out bool is_cut) {
  int3 at = cell & (((int3)1 << voxc_s5_h2_2_2_LEVEL_2_LOG2_SIZE) - 1);
  uint number = uint(at.x + ((at.y
      + (at.z << voxc_s5_h2_2_2_LEVEL_2_LOG2_SIZE.y)) << voxc_s5_h2_2_2_LEVEL_2_LOG2_SIZE.x));
  uint log2_entries = voxc_s5_h2_2_2_load_word(volume, table);
  uint probes = voxc_s5_h2_2_2_load_word(volume, table + 1u);
  uint home = number * 0x9e3779b1u >> (32u - log2_entries);
  uint found = 0u;
  uint probe = 0u;
  while (probe < probes) {
    uint entry = table + 2u + 2u * (home + probe & ((1u << log2_entries) - 1u));
    uint value = voxc_s5_h2_2_2_load_word(volume, entry + 1u);
    bool is_cell = voxc_s5_h2_2_2_load_word(volume, entry) == number;
    found = is_cell ? value : found;
    probe = is_cell || value == 0u ? probes : probe + 1u;
  }
  is_cut = probe != probes;
  return found;
}

// The same. The span has no cells if the device cut the search short.
uint voxc_s5_h2_2_2_look_up_level_2(VOXC_VOLUME volume, uint table, int3 cell) {
  bool is_cut;
  return voxc_s5_h2_2_2_probe_level_2(volume, table, cell, is_cut);
}

// Whether a traversal is still in the sub-volume in which it began.
bool voxc_s5_h2_2_2_within_level_2(int3 begin, int3 cell) {
  return voxc_s5_h2_2_2_is_same_cube(begin, cell, voxc_s5_h2_2_2_LEVEL_2_LOG2_SIDE);
}

bool voxc_s5_h2_2_2_intersect_level_2(VOXC_VOLUME volume, const voxc_s5_h2_2_2_Ray ray,
    inout voxc_s5_h2_2_2_Traversal traversal, uint grid) {
  int3 begin = traversal.cell;
  while (voxc_s5_h2_2_2_within_level_2(begin, traversal.cell)) {
    uint value = voxc_s5_h2_2_2_look_up_level_2(volume, grid, traversal.cell >> voxc_s5_h2_2_2_LEVEL_2_LOG2_CELL);
    if (value == 0u) {
      voxc_s5_h2_2_2_step_over_voxel(ray, traversal);
    } else if (voxc_s5_h2_2_2_intersect_voxel(traversal, value)) {
      return true;
    }
  }
  return false;
}

// Level 1: svo, 32 x 32 x 32 cells of 4 voxels a side.
static const int voxc_s5_h2_2_2_LEVEL_1_DEPTH = 5;
static const int voxc_s5_h2_2_2_LEVEL_1_LOG2_CELL = 2;

// A node of an octree is [first child, masks]; its children that are not empty stand together, two words each.
// Gives the child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
uint voxc_s5_h2_2_2_child_level_1(VOXC_VOLUME volume, uint node, int3 cell, int height, out bool leaf) {
  int child = voxc_s5_h2_2_2_child_index(cell >> height);
  uint masks = voxc_s5_h2_2_2_load_word(volume, node + 1u);
  leaf = (masks >> (8 + child) & 1u) != 0u;
  if ((masks >> child & 1u) == 0u)
    return 0u;
  return voxc_s5_h2_2_2_load_word(volume, node) + 2u * uint(int(countbits(masks & ((1u << child) - 1u))));
}

// path[i] is the node i layers above the cells around the traversal's cell: a step climbs only to the ancestor of the
// old cell and the new.
bool voxc_s5_h2_2_2_intersect_level_1(VOXC_VOLUME volume, const voxc_s5_h2_2_2_Ray ray,
    inout voxc_s5_h2_2_2_Traversal traversal, uint root) {
  uint path[voxc_s5_h2_2_2_LEVEL_1_DEPTH + 1];
  path[voxc_s5_h2_2_2_LEVEL_1_DEPTH] = root;
  int top = voxc_s5_h2_2_2_LEVEL_1_DEPTH;
  for (;;) {
    int3 cell = traversal.cell >> voxc_s5_h2_2_2_LEVEL_1_LOG2_CELL;
    uint node = path[top];
    int layer = top;
    bool leaf = false;
    while (node != 0u && !leaf) {
      path[layer] = node;
      layer--;
      node = voxc_s5_h2_2_2_child_level_1(volume, node, cell, layer, leaf);
    }
    int3 before = traversal.cell;
    if (node == 0u)
      voxc_s5_h2_2_2_step_over(ray, traversal, voxc_s5_h2_2_2_LEVEL_1_LOG2_CELL + layer);
    else {
      bool chosen_1;
      chosen_1 = leaf;
      if (chosen_1)
        chosen_1 = voxc_s5_h2_2_2_intersect_level_2(volume, ray, traversal, voxc_s5_h2_2_2_load_word(volume, node));
      if (chosen_1)
        return true;
    }

    if (!voxc_s5_h2_2_2_goes_on(traversal))
      return false;
    int3 changed = before ^ traversal.cell;
    int highest = int(firstbithigh(uint(changed.x | changed.y | changed.z)));
    top = max(layer, highest - voxc_s5_h2_2_2_LEVEL_1_LOG2_CELL) + 1;
  }
}

// What a voxel is: here its value is its colour.
uint voxc_s5_h2_2_2_colour_of(const voxc_s5_h2_2_2_Traversal traversal) { return traversal.voxel; }

