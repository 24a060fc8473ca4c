// ---- The format: S(4) G(5) ----

// Which child of a node a place lies in, counted in children.
int voxc_s4_g5_child_index(ivec3 place) {
  ivec3 bits = place & 1;
  return bits.x | bits.y << 1 | bits.z << 2;
}

// Level 2: svdag, 32 x 32 x 32 cells of 1 voxel a side.
const int voxc_s4_g5_LEVEL_2_LOG2_CELL = 0;
const int voxc_s4_g5_LEVEL_2_LOG2_SIDE = 5;

// A node is [masks, slots of its children...]: a bit for each child that is not empty, one for each that is a leaf, and
// slots of those that are not empty or, where all leaves have one value, that are neither empty nor leaves. Gives the
// child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
uint voxc_s4_g5_child_level_2(VOXC_VOLUME volume, uint node, ivec3 cell, int height, out bool leaf) {
  int child = voxc_s4_g5_child_index(cell >> height);
  uint masks = voxc_s4_g5_load_word(volume, node);
  leaf = (masks >> (8 + child) & 1u) != 0u;
  if ((masks >> child & 1u) == 0u)
    return 0u;
  return voxc_s4_g5_load_word(volume, node + 1u + uint(bitCount(masks & ((1u << child) - 1u))));
}

// Level 1: svo, 16 x 16 x 16 cells of 32 voxels a side.
const int voxc_s4_g5_LEVEL_1_LOG2_CELL = 5;
const int voxc_s4_g5_LEVEL_1_LOG2_SIDE = 9;

// A node of an octree is [first child, masks]; its children that are not empty stand together, two words each.
// Gives the child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
uint voxc_s4_g5_child_level_1(VOXC_VOLUME volume, uint node, ivec3 cell, int height, out bool leaf) {
  int child = voxc_s4_g5_child_index(cell >> height);
  uint masks = voxc_s4_g5_load_word(volume, node + 1u);
  leaf = (masks >> (8 + child) & 1u) != 0u;
  if ((masks >> child & 1u) == 0u)
    return 0u;
  return voxc_s4_g5_load_word(volume, node) + 2u * uint(bitCount(masks & ((1u << child) - 1u)));
}

// The layers of all levels, counted from the root. Of a level, the lowest that has a node around the traversal's cell:
// a leaf may stand above the others.
struct voxc_s4_g5_Lowest {
  int layer[2];
};

void voxc_s4_g5_look_up_layer_level_2(VOXC_VOLUME volume, ivec3 cell, inout uint node, inout int layer,
    inout voxc_s4_g5_EmptySpan span, inout uint value) {
  bool leaf = false;
  int below = 8 - layer;
  node = voxc_s4_g5_child_level_2(volume, node, cell >> voxc_s4_g5_LEVEL_2_LOG2_CELL, below, leaf);
  span = voxc_s4_g5_EmptySpan(voxc_s4_g5_LEVEL_2_LOG2_CELL + below, 1);
  if (node != 0u && !leaf) {
    layer++;
  } else if (node != 0u) {
    value = node;
    node = 0u;
  }
}

// The layer of the lowest node, of this level and those below, that has both cells of a step. Their numbers differ in
// no bit above the highest.
int voxc_s4_g5_common_layer_level_2(int highest) {
  int layer = 4;
  layer = min(4 + (voxc_s4_g5_LEVEL_2_LOG2_SIDE - 1 - highest), 8);
  return layer;
}

void voxc_s4_g5_look_up_layer_level_1(VOXC_VOLUME volume, ivec3 cell, inout uint node, inout int layer,
    inout voxc_s4_g5_Lowest lowest, inout voxc_s4_g5_EmptySpan span, inout uint value) {
  if (layer < 4) {
    bool leaf = false;
    int below = 3 - layer;
    node = voxc_s4_g5_child_level_1(volume, node, cell >> voxc_s4_g5_LEVEL_1_LOG2_CELL, below, leaf);
    span = voxc_s4_g5_EmptySpan(voxc_s4_g5_LEVEL_1_LOG2_CELL + below, 1);
    lowest.layer[0] = layer;
    if (node != 0u && !leaf) {
      layer++;
    } else if (node != 0u) {
      node = voxc_s4_g5_load_word(volume, node);
      layer = 4;
    }
  } else {
    voxc_s4_g5_look_up_layer_level_2(volume, cell, node, layer, span, value);
  }
}

// The layer of the lowest node, of this level and those below, that has both cells of a step. Their numbers differ in
// no bit above the highest.
int voxc_s4_g5_common_layer_level_1(int highest, const voxc_s4_g5_Lowest lowest) {
  int layer = 0;
  layer = min(voxc_s4_g5_LEVEL_1_LOG2_SIDE - 1 - highest, lowest.layer[0]);
  return highest < voxc_s4_g5_LEVEL_1_LOG2_CELL ? voxc_s4_g5_common_layer_level_2(highest) : layer;
}

// All levels in one loop. path[i] is the node in layer i around the traversal's cell, counted from the root through all
// levels; a step climbs only to the lowest node that has the old cell and the new.
bool voxc_s4_g5_intersect_level_1(VOXC_VOLUME volume, const voxc_s4_g5_Ray ray, inout voxc_s4_g5_Traversal traversal,
    uint root) {
  uint path[9];
  path[0] = root;
  int layer = 0;
  voxc_s4_g5_Lowest lowest;
  lowest.layer[0] = 0;
  lowest.layer[1] = 0;
  while (voxc_s4_g5_goes_on(traversal)) {
    uint node = path[layer];
    uint value = 0u;
    voxc_s4_g5_EmptySpan span = voxc_s4_g5_EmptySpan(0, 1);
    while (node != 0u) {
      path[layer] = node;
      voxc_s4_g5_look_up_layer_level_1(volume, traversal.cell, node, layer, lowest, span, value);
    }
    if (value != 0u) {
      traversal.voxel = value;
      return true;
    }
    ivec3 before = traversal.cell;
    bool is_empty = node == 0u; // Else the device ended the loop above, or one in it.
    if (is_empty)
      voxc_s4_g5_step_over(ray, traversal, span);
    ivec3 changed = before ^ traversal.cell;
    int highest = findMSB(uint(changed.x | changed.y | changed.z));
    layer = min(layer, voxc_s4_g5_common_layer_level_1(highest, lowest));
  }
  return false;
}

// What a voxel is: here its value is its colour.
uint voxc_s4_g5_colour_of(VOXC_VOLUME volume, const voxc_s4_g5_Traversal traversal) {
  return voxc_s4_g5_load_word(volume, traversal.voxel);
}

