// ---- The format: S(4) G(5) ----

// Which child of a node a place lies in, counted in children.
fn voxc_s4_g5_child_index(place: vec3<i32>) -> i32 {
  let bits = place & vec3<i32>(1);
  return bits.x | (bits.y << 1u) | (bits.z << 2u);
}

// Level 2: svdag, 32 x 32 x 32 cells of 1 voxel a side.
const voxc_s4_g5_LEVEL_2_LOG2_CELL: i32 = 0;
const voxc_s4_g5_LEVEL_2_LOG2_SIDE: i32 = 5;

// A node is [masks, slots of its children...]: a bit for each child that is not empty, one for each that is a leaf, and
// slots of those that are not empty or, where all leaves have one value, that are neither empty nor leaves. Gives the
// child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
fn voxc_s4_g5_child_level_2(volume: u32, node: u32, cell: vec3<i32>, height: i32, leaf: ptr<function, bool>) -> u32 {
  let child = voxc_s4_g5_child_index(cell >> vec3<u32>(u32(height)));
  let masks = voxc_s4_g5_load_word(volume, node);
  *leaf = ((masks >> u32(8 + child)) & 1u) != 0u;
  if (((masks >> u32(child)) & 1u) == 0u) {
    return 0u;
  }
  return voxc_s4_g5_load_word(volume, node + 1u + countOneBits(masks & ((1u << u32(child)) - 1u)));
}

// Level 1: svo, 16 x 16 x 16 cells of 32 voxels a side.
const voxc_s4_g5_LEVEL_1_LOG2_CELL: i32 = 5;
const voxc_s4_g5_LEVEL_1_LOG2_SIDE: i32 = 9;

// A node of an octree is [first child, masks]; its children that are not empty stand together, two words each.
// Gives the child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
fn voxc_s4_g5_child_level_1(volume: u32, node: u32, cell: vec3<i32>, height: i32, leaf: ptr<function, bool>) -> u32 {
  let child = voxc_s4_g5_child_index(cell >> vec3<u32>(u32(height)));
  let masks = voxc_s4_g5_load_word(volume, node + 1u);
  *leaf = ((masks >> u32(8 + child)) & 1u) != 0u;
  if (((masks >> u32(child)) & 1u) == 0u) {
    return 0u;
  }
  return voxc_s4_g5_load_word(volume, node) + 2u * countOneBits(masks & ((1u << u32(child)) - 1u));
}

// The layers of all levels, counted from the root. Of a level, the lowest that has a node around the traversal's cell:
// a leaf may stand above the others.
struct voxc_s4_g5_Lowest {
  layer: array<i32, 2>,
}

fn voxc_s4_g5_look_up_layer_level_2(volume: u32, cell: vec3<i32>, node: ptr<function, u32>, layer: ptr<function, i32>,
    span: ptr<function, voxc_s4_g5_EmptySpan>, value: ptr<function, u32>) {
  var leaf: bool = false;
  let below = 8 - *layer;
  *node = voxc_s4_g5_child_level_2(volume, *node, cell >> vec3<u32>(u32(voxc_s4_g5_LEVEL_2_LOG2_CELL)), below, &leaf);
  *span = voxc_s4_g5_EmptySpan(voxc_s4_g5_LEVEL_2_LOG2_CELL + below, 1);
  if (*node != 0u && !leaf) {
    (*layer)++;
  } else if (*node != 0u) {
    *value = *node;
    *node = 0u;
  }
}

// The layer of the lowest node, of this level and those below, that has both cells of a step. Their numbers differ in
// no bit above the highest.
fn voxc_s4_g5_common_layer_level_2(highest: i32) -> i32 {
  var layer: i32 = 4;
  layer = min(4 + (voxc_s4_g5_LEVEL_2_LOG2_SIDE - 1 - highest), 8);
  return layer;
}

fn voxc_s4_g5_look_up_layer_level_1(volume: u32, cell: vec3<i32>, node: ptr<function, u32>, layer: ptr<function, i32>,
    lowest: ptr<function, voxc_s4_g5_Lowest>, span: ptr<function, voxc_s4_g5_EmptySpan>, value: ptr<function, u32>) {
  if (*layer < 4) {
    var leaf: bool = false;
    let below = 3 - *layer;
    *node = voxc_s4_g5_child_level_1(volume, *node, cell >> vec3<u32>(u32(voxc_s4_g5_LEVEL_1_LOG2_CELL)), below, &leaf);
    *span = voxc_s4_g5_EmptySpan(voxc_s4_g5_LEVEL_1_LOG2_CELL + below, 1);
    (*lowest).layer[0] = *layer;
    if (*node != 0u && !leaf) {
      (*layer)++;
    } else if (*node != 0u) {
      *node = voxc_s4_g5_load_word(volume, *node);
      *layer = 4;
    }
  } else {
    voxc_s4_g5_look_up_layer_level_2(volume, cell, node, layer, span, value);
  }
}

// The layer of the lowest node, of this level and those below, that has both cells of a step. Their numbers differ in
// no bit above the highest.
fn voxc_s4_g5_common_layer_level_1(highest: i32, lowest: voxc_s4_g5_Lowest) -> i32 {
  var layer: i32 = 0;
  layer = min(voxc_s4_g5_LEVEL_1_LOG2_SIDE - 1 - highest, lowest.layer[0]);
  if (highest < voxc_s4_g5_LEVEL_1_LOG2_CELL) {
    return voxc_s4_g5_common_layer_level_2(highest);
  }
  return layer;
}

// All levels in one loop. path[i] is the node in layer i around the traversal's cell, counted from the root through all
// levels; a step climbs only to the lowest node that has the old cell and the new.
fn voxc_s4_g5_intersect_level_1(volume: u32, ray: voxc_s4_g5_Ray, traversal: ptr<function, voxc_s4_g5_Traversal>,
    root: u32) -> bool {
  var path: array<u32, 9>;
  path[0] = root;
  var layer: i32 = 0;
  var lowest: voxc_s4_g5_Lowest;
  lowest.layer[0] = 0;
  lowest.layer[1] = 0;
  while (voxc_s4_g5_goes_on(*traversal)) {
    var node: u32 = path[layer];
    var value: u32 = 0u;
    var span: voxc_s4_g5_EmptySpan = voxc_s4_g5_EmptySpan(0, 1);
    while (node != 0u) {
      path[layer] = node;
      voxc_s4_g5_look_up_layer_level_1(volume, (*traversal).cell, &node, &layer, &lowest, &span, &value);
    }
    if (value != 0u) {
      (*traversal).voxel = value;
      return true;
    }
    let before = (*traversal).cell;
    let is_empty = node == 0u; // Else the device ended the loop above, or one in it.
    if (is_empty) {
      voxc_s4_g5_step_over_emptyspan(ray, traversal, span);
    }
    let changed = before ^ (*traversal).cell;
    let highest = i32(firstLeadingBit(u32(changed.x | changed.y | changed.z)));
    layer = min(layer, voxc_s4_g5_common_layer_level_1(highest, lowest));
  }
  return false;
}

// What a voxel is: here its value is its colour.
fn voxc_s4_g5_colour_of(volume: u32, traversal: voxc_s4_g5_Traversal) -> u32 {
  return voxc_s4_g5_load_word(volume, traversal.voxel);
}

