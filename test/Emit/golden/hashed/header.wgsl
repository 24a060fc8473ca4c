// ---- The format: S(5) H(2, 2, 2) ----

// Which child of a node a place lies in, counted in children.
fn voxc_s5_h2_2_2_child_index(place: vec3<i32>) -> i32 {
  let bits = place & vec3<i32>(1);
  return bits.x | (bits.y << 1u) | (bits.z << 2u);
}

// Level 2: hash, 4 x 4 x 4 cells of 1 voxel a side.
const voxc_s5_h2_2_2_LEVEL_2_LOG2_SIZE: vec3<i32> = vec3<i32>(2, 2, 2);
const voxc_s5_h2_2_2_LEVEL_2_LOG2_CELL: i32 = 0;
const voxc_s5_h2_2_2_LEVEL_2_LOG2_SIDE: i32 = 2;

// A hashed grid is [log2 of its entries, longest probe], then two words an entry: a cell's number, its value. Entries
// of value 0 are free. The value of a cell, or 0 if it is empty. The device may cut the search short.
fn voxc_s5_h2_2_2_probe_level_2(volume: u32, table: u32, cell: vec3<i32>, is_cut: ptr<function, bool>) -> u32 {
  let at = cell & ((vec3<i32>(1) << vec3<u32>(voxc_s5_h2_2_2_LEVEL_2_LOG2_SIZE)) - 1);
  let number = u32(at.x + ((at.y
      + (at.z << u32(voxc_s5_h2_2_2_LEVEL_2_LOG2_SIZE.y))) << u32(voxc_s5_h2_2_2_LEVEL_2_LOG2_SIZE.x)));
  let log2_entries = voxc_s5_h2_2_2_load_word(volume, table);
  let probes = voxc_s5_h2_2_2_load_word(volume, table + 1u);
  let home = (number * 0x9e3779b1u) >> (32u - log2_entries);
  var found: u32 = 0u;
  var probe: u32 = 0u;
  while (probe < probes) {
    let entry = table + 2u + 2u * ((home + probe) & ((1u << log2_entries) - 1u));
    let value = voxc_s5_h2_2_2_load_word(volume, entry + 1u);
    let is_cell = voxc_s5_h2_2_2_load_word(volume, entry) == number;
    found = select(found, value, is_cell);
    probe = select(probe + 1u, probes, is_cell || (value == 0u));
  }
  *is_cut = probe != probes;
  return found;
}

// The same. The span has no cells if the device cut the search short.
fn voxc_s5_h2_2_2_look_up_level_2(volume: u32, table: u32, cell: vec3<i32>) -> u32 {
  var is_cut: bool;
  return voxc_s5_h2_2_2_probe_level_2(volume, table, cell, &is_cut);
}

// Whether a traversal is still in the sub-volume in which it began.
fn voxc_s5_h2_2_2_within_level_2(begin: vec3<i32>, cell: vec3<i32>) -> bool {
  return voxc_s5_h2_2_2_is_same_cube(begin, cell, voxc_s5_h2_2_2_LEVEL_2_LOG2_SIDE);
}

fn voxc_s5_h2_2_2_intersect_level_2(volume: u32, ray: voxc_s5_h2_2_2_Ray, traversal: ptr<function,
    voxc_s5_h2_2_2_Traversal>, grid: u32) -> bool {
  let begin = (*traversal).cell;
  while (voxc_s5_h2_2_2_within_level_2(begin, (*traversal).cell)) {
    let value = voxc_s5_h2_2_2_look_up_level_2(volume, grid,
        (*traversal).cell >> vec3<u32>(u32(voxc_s5_h2_2_2_LEVEL_2_LOG2_CELL)));
    if (value == 0u) {
      voxc_s5_h2_2_2_step_over_voxel(ray, traversal);
    } else if (voxc_s5_h2_2_2_intersect_voxel(traversal, value)) {
      return true;
    }
  }
  return false;
}

// Level 1: svo, 32 x 32 x 32 cells of 4 voxels a side.
const voxc_s5_h2_2_2_LEVEL_1_DEPTH: i32 = 5;
const voxc_s5_h2_2_2_LEVEL_1_LOG2_CELL: i32 = 2;

// A node of an octree is [first child, masks]; its children that are not empty stand together, two words each.
// Gives the child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
fn voxc_s5_h2_2_2_child_level_1(volume: u32, node: u32, cell: vec3<i32>, height: i32, leaf: ptr<function,
    bool>) -> u32 {
  let child = voxc_s5_h2_2_2_child_index(cell >> vec3<u32>(u32(height)));
  let masks = voxc_s5_h2_2_2_load_word(volume, node + 1u);
  *leaf = ((masks >> u32(8 + child)) & 1u) != 0u;
  if (((masks >> u32(child)) & 1u) == 0u) {
    return 0u;
  }
  return voxc_s5_h2_2_2_load_word(volume, node) + 2u * countOneBits(masks & ((1u << u32(child)) - 1u));
}

// path[i] is the node i layers above the cells around the traversal's cell: a step climbs only to the ancestor of the
// old cell and the new.
fn voxc_s5_h2_2_2_intersect_level_1(volume: u32, ray: voxc_s5_h2_2_2_Ray, traversal: ptr<function,
    voxc_s5_h2_2_2_Traversal>, root: u32) -> bool {
  var path: array<u32, voxc_s5_h2_2_2_LEVEL_1_DEPTH + 1>;
  path[voxc_s5_h2_2_2_LEVEL_1_DEPTH] = root;
  var top: i32 = voxc_s5_h2_2_2_LEVEL_1_DEPTH;
  for (;;) {
    let cell = (*traversal).cell >> vec3<u32>(u32(voxc_s5_h2_2_2_LEVEL_1_LOG2_CELL));
    var node: u32 = path[top];
    var layer: i32 = top;
    var leaf: bool = false;
    while (node != 0u && !leaf) {
      path[layer] = node;
      layer--;
      node = voxc_s5_h2_2_2_child_level_1(volume, node, cell, layer, &leaf);
    }
    let before = (*traversal).cell;
    if (node == 0u) {
      voxc_s5_h2_2_2_step_over_int(ray, traversal, voxc_s5_h2_2_2_LEVEL_1_LOG2_CELL + layer);
    } else if (leaf && voxc_s5_h2_2_2_intersect_level_2(volume, ray, traversal, voxc_s5_h2_2_2_load_word(volume,
        node))) {
      return true;
    }

    if (!voxc_s5_h2_2_2_goes_on(*traversal)) {
      return false;
    }
    let changed = before ^ (*traversal).cell;
    let highest = i32(firstLeadingBit(u32(changed.x | changed.y | changed.z)));
    top = max(layer, highest - voxc_s5_h2_2_2_LEVEL_1_LOG2_CELL) + 1;
  }
}

// What a voxel is: here its value is its colour.
fn voxc_s5_h2_2_2_colour_of(traversal: voxc_s5_h2_2_2_Traversal) -> u32 { return traversal.voxel; }

