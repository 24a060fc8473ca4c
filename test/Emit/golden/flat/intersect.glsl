// ---- The format: S(4) G(5) ----

// Which child of a node a place lies in, counted in children.
int child_index(ivec3 place) {
  ivec3 bits = place & 1;
  return bits.x | bits.y << 1 | bits.z << 2;
}

// Level 2: svdag, 32 x 32 x 32 cells of 1 voxel a side.
const int LEVEL_2_LOG2_CELL = 0;
const int LEVEL_2_LOG2_SIDE = 5;

// A node is [masks, slots of its children...]: a bit for each child that is not empty, one for each that is a leaf, and
// slots of those that are not empty or, where all leaves have one value, that are neither empty nor leaves. Gives the
// child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
uint child_level_2(uint node, ivec3 cell, int height, out bool leaf) {
  int child = child_index(cell >> height);
  uint masks = load_word(node);
  leaf = (masks >> (8 + child) & 1u) != 0u;
  if ((masks >> child & 1u) == 0u)
    return 0u;
  return load_word(node + 1u + uint(bitCount(masks & ((1u << child) - 1u))));
}

// Level 1: svo, 16 x 16 x 16 cells of 32 voxels a side.
const int LEVEL_1_LOG2_CELL = 5;
const int LEVEL_1_LOG2_SIDE = 9;

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

// The layers of all levels, counted from the root. Of a level, the lowest that has a node around the traversal's cell:
// a leaf may stand above the others.
struct Lowest {
  int layer[2];
};

void look_up_layer_level_2(ivec3 cell, inout uint node, inout int layer, inout EmptySpan span, inout uint value) {
  bool leaf = false;
  int below = 8 - layer;
  node = child_level_2(node, cell >> LEVEL_2_LOG2_CELL, below, leaf);
  span = EmptySpan(LEVEL_2_LOG2_CELL + below, 1);
  if (node != 0u && !leaf) {
    layer++;
  } else if (node != 0u) {
    value = node;
    node = 0u;
  }
}

// The layer of the lowest node, of this level and those below, that has both cells of a step. Their numbers differ in
// no bit above the highest.
int common_layer_level_2(int highest) {
  int layer = 4;
  layer = min(4 + (LEVEL_2_LOG2_SIDE - 1 - highest), 8);
  return layer;
}

void look_up_layer_level_1(ivec3 cell, inout uint node, inout int layer, inout Lowest lowest, inout EmptySpan span,
    inout uint value) {
  if (layer < 4) {
    bool leaf = false;
    int below = 3 - layer;
    node = child_level_1(node, cell >> LEVEL_1_LOG2_CELL, below, leaf);
    span = EmptySpan(LEVEL_1_LOG2_CELL + below, 1);
    lowest.layer[0] = layer;
    if (node != 0u && !leaf) {
      layer++;
    } else if (node != 0u) {
      node = load_word(node);
      layer = 4;
    }
  } else {
    look_up_layer_level_2(cell, node, layer, span, value);
  }
}

// The layer of the lowest node, of this level and those below, that has both cells of a step. Their numbers differ in
// no bit above the highest.
int common_layer_level_1(int highest, const Lowest lowest) {
  int layer = 0;
  layer = min(LEVEL_1_LOG2_SIDE - 1 - highest, lowest.layer[0]);
  return highest < LEVEL_1_LOG2_CELL ? common_layer_level_2(highest) : layer;
}

// All levels in one loop. path[i] is the node in layer i around the traversal's cell, counted from the root through all
// levels; a step climbs only to the lowest node that has the old cell and the new.
shared uint path_level_1[9][gl_WorkGroupSize.x];

bool intersect_level_1(const Ray ray, inout Traversal traversal, uint root) {
  path_level_1[0][gl_LocalInvocationIndex] = root;
  int layer = 0;
  Lowest lowest;
  lowest.layer[0] = 0;
  lowest.layer[1] = 0;
  while (goes_on(traversal)) {
    // Down to a voxel, or to the empty span around the cell.
    count_lookup(traversal);
    uint node = path_level_1[layer][gl_LocalInvocationIndex];
    uint value = 0u;
    EmptySpan span = EmptySpan(0, 1);
    while (node != 0u) {
      path_level_1[layer][gl_LocalInvocationIndex] = node;
      look_up_layer_level_1(traversal.cell, node, layer, lowest, span, value);
    }
    if (value != 0u) {
      traversal.voxel = value;
      return true;
    }
    ivec3 before = traversal.cell;
    bool is_empty = node == 0u; // Else the device ended the loop above, or one in it.
    if (is_empty)
      step_over(ray, traversal, span);
    ivec3 changed = before ^ traversal.cell;
    int highest = findMSB(uint(changed.x | changed.y | changed.z));
    layer = min(layer, common_layer_level_1(highest, lowest));
  }
  return false;
}

// What a voxel is: here its value is its colour.
uint colour_of(const Traversal traversal) { return load_word(traversal.voxel); }

