// ---- The format: S(5) H(2, 2, 2) ----

// Which child of a node a place lies in, counted in children.
int child_index(ivec3 place) {
  ivec3 bits = place & 1;
  return bits.x | bits.y << 1 | bits.z << 2;
}

// Level 2: hash, 4 x 4 x 4 cells of 1 voxel a side.
const ivec3 LEVEL_2_LOG2_SIZE = ivec3(2, 2, 2);
const int LEVEL_2_LOG2_CELL = 0;
const int LEVEL_2_LOG2_SIDE = 2;

// A hashed grid is [log2 of its entries, longest probe], then two words an entry: a cell's number, its value. Entries
// of value 0 are free. The value of a cell, or 0 if it is empty. The device may cut the search short.
uint probe_level_2(uint table, ivec3 cell, out bool is_cut) {
  ivec3 at = cell & ((ivec3(1) << LEVEL_2_LOG2_SIZE) - 1);
  uint number = uint(at.x + ((at.y + (at.z << LEVEL_2_LOG2_SIZE.y)) << LEVEL_2_LOG2_SIZE.x));
  uint log2_entries = load_word(table);
  uint probes = load_word(table + 1u);
  uint home = number * 0x9e3779b1u >> (32u - log2_entries);
  uint found = 0u;
  uint probe = 0u;
  while (probe < probes) {
    uint entry = table + 2u + 2u * (home + probe & ((1u << log2_entries) - 1u));
    uint value = load_word(entry + 1u);
    bool is_cell = load_word(entry) == number;
    found = is_cell ? value : found;
    probe = is_cell || value == 0u ? probes : probe + 1u;
  }
  is_cut = probe != probes;
  return found;
}

// The same. The span has no cells if the device cut the search short.
uint look_up_level_2(uint table, ivec3 cell, inout EmptySpan span) {
  bool is_cut;
  uint value = probe_level_2(table, cell, is_cut);
  span.count = is_cut ? 0 : 1;
  return value;
}

// Whether a traversal is still in the sub-volume in which it began.
bool within_level_2(ivec3 begin, ivec3 cell) { return is_same_cube(begin, cell, LEVEL_2_LOG2_SIDE); }

bool intersect_level_2(const Ray ray, inout Traversal traversal, uint grid) {
  ivec3 begin = traversal.cell;
  while (within_level_2(begin, traversal.cell)) {
    count_lookup(traversal);
    EmptySpan span = EmptySpan(LEVEL_2_LOG2_CELL, 1);
    uint value = look_up_level_2(grid, traversal.cell >> LEVEL_2_LOG2_CELL, span);
    if (value == 0u && span.count == 0)
      continue; // The device ended the look-up.
    if (value == 0u) {
      step_over_voxel(ray, traversal);
    } else if (intersect_voxel(traversal, value)) {
      return true;
    }
  }
  return false;
}

// Level 1: svo, 32 x 32 x 32 cells of 4 voxels a side.
const int LEVEL_1_DEPTH = 5;
const int LEVEL_1_LOG2_CELL = 2;

// A node of an octree is [first child, masks]; its children that are not empty stand together, two words each.
// Gives the child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
uint child_level_1(uint node, ivec3 cell, int height, out bool leaf) {
  int child = child_index(cell >> height);
  uint masks = load_word(node + 1u);
  leaf = (masks >> (8 + child) & 1u) != 0u;
  if ((masks >> child & 1u) == 0u)
    return 0u;
  return load_word(node) + 2u * uint(bitCount(masks & ((1u << child) - 1u)));
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
    else if (leaf && intersect_level_2(ray, traversal, load_word(node)))
      return true;

    if (!goes_on(traversal))
      return false;
    ivec3 changed = before ^ traversal.cell;
    int highest = findMSB(uint(changed.x | changed.y | changed.z));
    top = max(layer, highest - LEVEL_1_LOG2_CELL) + 1;
  }
}

// What a voxel is: here its value is its colour.
uint colour_of(const Traversal traversal) { return traversal.voxel; }

