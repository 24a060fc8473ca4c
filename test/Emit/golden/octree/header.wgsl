// ---- The format: S(9) ----

// Which child of a node a place lies in, counted in children.
fn voxc_s9_child_index(place: vec3<i32>) -> i32 {
  let bits = place & vec3<i32>(1);
  return bits.x | (bits.y << 1u) | (bits.z << 2u);
}

// Level 1: svo, 512 x 512 x 512 cells of 1 voxel a side.
const voxc_s9_LEVEL_1_DEPTH: i32 = 9;
const voxc_s9_LEVEL_1_LOG2_CELL: i32 = 0;

// A node of an octree is [first child, masks]; its children that are not empty stand together, two words each.
// Gives the child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
fn voxc_s9_child_level_1(volume: u32, node: u32, cell: vec3<i32>, height: i32, leaf: ptr<function, bool>) -> u32 {
  let child = voxc_s9_child_index(cell >> vec3<u32>(u32(height)));
  let masks = voxc_s9_load_word(volume, node + 1u);
  *leaf = ((masks >> u32(8 + child)) & 1u) != 0u;
  if (((masks >> u32(child)) & 1u) == 0u) {
    return 0u;
  }
  return voxc_s9_load_word(volume, node) + 2u * countOneBits(masks & ((1u << u32(child)) - 1u));
}

// path[i] is the node i layers above the cells around the traversal's cell: a step climbs only to the ancestor of the
// old cell and the new.
fn voxc_s9_intersect_level_1(volume: u32, ray: voxc_s9_Ray, traversal: ptr<function, voxc_s9_Traversal>,
    root: u32) -> bool {
  var path: array<u32, voxc_s9_LEVEL_1_DEPTH + 1>;
  path[voxc_s9_LEVEL_1_DEPTH] = root;
  var top: i32 = voxc_s9_LEVEL_1_DEPTH;
  for (;;) {
    let cell = (*traversal).cell >> vec3<u32>(u32(voxc_s9_LEVEL_1_LOG2_CELL));
    var node: u32 = path[top];
    var layer: i32 = top;
    var leaf: bool = false;
    while (node != 0u && !leaf) {
      path[layer] = node;
      layer--;
      node = voxc_s9_child_level_1(volume, node, cell, layer, &leaf);
    }
    let before = (*traversal).cell;
    if (node == 0u) {
      voxc_s9_step_over_int(ray, traversal, voxc_s9_LEVEL_1_LOG2_CELL + layer);
    } else if (leaf && voxc_s9_intersect_voxel(traversal, node)) {
      return true;
    }

    if (!voxc_s9_goes_on(*traversal)) {
      return false;
    }
    let changed = before ^ (*traversal).cell;
    let highest = i32(firstLeadingBit(u32(changed.x | changed.y | changed.z)));
    top = max(layer, highest - voxc_s9_LEVEL_1_LOG2_CELL) + 1;
  }
}

// What a voxel is: here its value is its colour.
fn voxc_s9_colour_of(volume: u32, traversal: voxc_s9_Traversal) -> u32 {
  return voxc_s9_load_word(volume, traversal.voxel);
}

