// ---- The format: G(9) ----

// Which child of a node a place lies in, counted in children.
fn voxc_g9_child_index(place: vec3<i32>) -> i32 {
  let bits = place & vec3<i32>(1);
  return bits.x | (bits.y << 1u) | (bits.z << 2u);
}

// Level 1: svdag, 512 x 512 x 512 cells of 1 voxel a side.
const voxc_g9_LEVEL_1_DEPTH: i32 = 9;
const voxc_g9_LEVEL_1_LOG2_CELL: i32 = 0;

// A node is [masks, references to the children that are neither empty nor leaves...]. The highest three bits of a
// reference say across which axes the node there is reflected, x lowest; on the way down, reflections add up. Gives the
// child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
fn voxc_g9_child_level_1(volume: u32, node: u32, cell: vec3<i32>, height: i32, leaf: ptr<function, bool>) -> u32 {
  let begin = node & 0x1fffffffu;
  let child = voxc_g9_child_index(cell >> vec3<u32>(u32(height))) ^ i32(node >> 29u);
  var masks: u32 = voxc_g9_load_word(volume, begin);
  *leaf = ((masks >> u32(8 + child)) & 1u) != 0u;
  if (((masks >> u32(child)) & 1u) == 0u) {
    return 0u;
  }
  if (*leaf) {
    return node; // All leaves have the same value.
  }
  masks &= ~(masks >> 8u);
  let slot = countOneBits(masks & ((1u << u32(child)) - 1u));
  return voxc_g9_load_word(volume, begin + 1u + slot) ^ (node & 0xe0000000u);
}

// path[i] is the node i layers above the cells around the traversal's cell: a step climbs only to the ancestor of the
// old cell and the new.
fn voxc_g9_intersect_level_1(volume: u32, ray: voxc_g9_Ray, traversal: ptr<function, voxc_g9_Traversal>,
    root: u32) -> bool {
  var path: array<u32, voxc_g9_LEVEL_1_DEPTH + 1>;
  path[voxc_g9_LEVEL_1_DEPTH] = root;
  var top: i32 = voxc_g9_LEVEL_1_DEPTH;
  for (;;) {
    let cell = (*traversal).cell >> vec3<u32>(u32(voxc_g9_LEVEL_1_LOG2_CELL));
    var node: u32 = path[top];
    var layer: i32 = top;
    var leaf: bool = false;
    while (node != 0u && !leaf) {
      path[layer] = node;
      layer--;
      node = voxc_g9_child_level_1(volume, node, cell, layer, &leaf);
    }
    let before = (*traversal).cell;
    if (node == 0u) {
      voxc_g9_step_over_int(ray, traversal, voxc_g9_LEVEL_1_LOG2_CELL + layer);
    } else if (leaf && voxc_g9_intersect_voxel()) {
      return true;
    }

    if (!voxc_g9_goes_on(*traversal)) {
      return false;
    }
    let changed = before ^ (*traversal).cell;
    let highest = i32(firstLeadingBit(u32(changed.x | changed.y | changed.z)));
    top = max(layer, highest - voxc_g9_LEVEL_1_LOG2_CELL) + 1;
  }
}

// What a voxel is: here nothing but that it is there, which is shown in white.
fn voxc_g9_colour_of() -> u32 { return 0xffffffffu; }

