// ---- The format: D(4, 4, 4, 5) G(4) ----

// Which child of a node a place lies in, counted in children.
fn voxc_d4_4_4_5_g4_child_index(place: vec3<i32>) -> i32 {
  let bits = place & vec3<i32>(1);
  return bits.x | (bits.y << 1u) | (bits.z << 2u);
}

// Level 2: svdag, 16 x 16 x 16 cells of 1 voxel a side.
const voxc_d4_4_4_5_g4_LEVEL_2_DEPTH: i32 = 4;
const voxc_d4_4_4_5_g4_LEVEL_2_LOG2_CELL: i32 = 0;
const voxc_d4_4_4_5_g4_LEVEL_2_LOG2_SIDE: i32 = 4;

// A node is [masks, slots of its children...]: a bit for each child that is not empty, one for each that is a leaf, and
// slots of those that are not empty or, where all leaves have one value, that are neither empty nor leaves. Gives the
// child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
fn voxc_d4_4_4_5_g4_child_level_2(volume: u32, node: u32, cell: vec3<i32>, height: i32, leaf: ptr<function,
    bool>) -> u32 {
  let child = voxc_d4_4_4_5_g4_child_index(cell >> vec3<u32>(u32(height)));
  let masks = voxc_d4_4_4_5_g4_load_word(volume, node);
  *leaf = ((masks >> u32(8 + child)) & 1u) != 0u;
  if (((masks >> u32(child)) & 1u) == 0u) {
    return 0u;
  }
  return voxc_d4_4_4_5_g4_load_word(volume, node + 1u + countOneBits(masks & ((1u << u32(child)) - 1u)));
}

// path[i] is the node i layers above the cells around the traversal's cell: a step climbs only to the ancestor of the
// old cell and the new.
fn voxc_d4_4_4_5_g4_intersect_level_2(volume: u32, ray: voxc_d4_4_4_5_g4_Ray, traversal: ptr<function,
    voxc_d4_4_4_5_g4_Traversal>, root: u32) -> bool {
  var path: array<u32, voxc_d4_4_4_5_g4_LEVEL_2_DEPTH + 1>;
  path[voxc_d4_4_4_5_g4_LEVEL_2_DEPTH] = root;
  var top: i32 = voxc_d4_4_4_5_g4_LEVEL_2_DEPTH;
  for (;;) {
    let cell = (*traversal).cell >> vec3<u32>(u32(voxc_d4_4_4_5_g4_LEVEL_2_LOG2_CELL));
    var node: u32 = path[top];
    var layer: i32 = top;
    var leaf: bool = false;
    while (node != 0u && !leaf) {
      path[layer] = node;
      layer--;
      node = voxc_d4_4_4_5_g4_child_level_2(volume, node, cell, layer, &leaf);
    }
    let before = (*traversal).cell;
    if (node == 0u) {
      voxc_d4_4_4_5_g4_step_over_int(ray, traversal, voxc_d4_4_4_5_g4_LEVEL_2_LOG2_CELL + layer);
    } else if (leaf && voxc_d4_4_4_5_g4_intersect_voxel(traversal, node)) {
      return true;
    }
    let changed = before ^ (*traversal).cell;
    let highest = i32(firstLeadingBit(u32(changed.x | changed.y | changed.z)));
    if (highest >= voxc_d4_4_4_5_g4_LEVEL_2_LOG2_SIDE) {
      return false;
    }
    top = max(layer, highest - voxc_d4_4_4_5_g4_LEVEL_2_LOG2_CELL) + 1;
  }
}

// Level 1: distance, 16 x 16 x 16 cells of 16 voxels a side.
const voxc_d4_4_4_5_g4_LEVEL_1_LOG2_SIZE: vec3<i32> = vec3<i32>(4, 4, 4);
const voxc_d4_4_4_5_g4_LEVEL_1_LOG2_CELL: i32 = 4;

// A grid has a slot a cell, x fastest, then y, then z.
// The place of a cell's slot: in that granule, where references count granules.
fn voxc_d4_4_4_5_g4_slot_level_1(grid: u32, cell: vec3<i32>) -> u32 {
  let at = cell;
  return grid + 2u * u32(at.x + ((at.y
      + (at.z << u32(voxc_d4_4_4_5_g4_LEVEL_1_LOG2_SIZE.y))) << u32(voxc_d4_4_4_5_g4_LEVEL_1_LOG2_SIZE.x)));
}

// The value of a cell, or 0 if it is empty; `span` then counts the cells of its distance.
fn voxc_d4_4_4_5_g4_look_up_level_1(volume: u32, grid: u32, cell: vec3<i32>, span: ptr<function,
    voxc_d4_4_4_5_g4_EmptySpan>) -> u32 {
  let slot = voxc_d4_4_4_5_g4_slot_level_1(grid, cell);
  let word = voxc_d4_4_4_5_g4_load_word(volume, slot);
  // The distance stands behind the value.
  var skip: u32;
  if (word == 0u) {
    skip = voxc_d4_4_4_5_g4_load_word(volume, slot + 1u);
  } else {
    skip = 0u;
  }
  (*span).count = i32(skip & 0x7fffffffu);
  return word;
}

// Whether a traversal is still in the sub-volume in which it began.
fn voxc_d4_4_4_5_g4_within_level_1(cell: vec3<i32>) -> bool { return voxc_d4_4_4_5_g4_is_in_volume(cell); }

// Steps from an empty cell to the first whose L1 distance is not below `left`, or that lies outside the sub-volume; no
// lookup is needed on the way.
fn voxc_d4_4_4_5_g4_march_level_1(ray: voxc_d4_4_4_5_g4_Ray, traversal: ptr<function, voxc_d4_4_4_5_g4_Traversal>,
    given_left: i32) {
  var left: i32 = given_left;
  let side = 1 << u32(voxc_d4_4_4_5_g4_LEVEL_1_LOG2_CELL);
  var face: vec3<i32> = voxc_d4_4_4_5_g4_corner_of((*traversal).cell,
      voxc_d4_4_4_5_g4_LEVEL_1_LOG2_CELL) + (ray.ahead & vec3<i32>(side));
  var corner: vec3<i32> = face; // `left` is at least 1, which compilers cannot know.
  var leaving: voxc_d4_4_4_5_g4_Exit = voxc_d4_4_4_5_g4_Exit(0.0f, vec3<bool>(false), true);
  // The condition stands at the head: Mesa 22.3's llvmpipe lets lanes that leave a loop further down run on.
  while (leaving.sure && left > 0) {
    face += side * select(vec3<i32>(0), ray.heading, leaving.passed);
    leaving = voxc_d4_4_4_5_g4_leave(ray, vec3<f32>(face));
    let step = select(vec3<i32>(0), ray.heading, leaving.passed);
    corner = face + side * (step - (ray.ahead & vec3<i32>(1)));
    left = select(0, left - (abs(step.x) + abs(step.y) + abs(step.z)), voxc_d4_4_4_5_g4_within_level_1(corner));
  }
  if (side > 1) {
    corner = voxc_d4_4_4_5_g4_cell_beyond(ray, vec3<f32>(face), &leaving);
  }
  voxc_d4_4_4_5_g4_end_step(traversal, leaving, corner, voxc_d4_4_4_5_g4_EmptySpan(voxc_d4_4_4_5_g4_LEVEL_1_LOG2_CELL,
      1));
}

fn voxc_d4_4_4_5_g4_intersect_level_1(volume: u32, ray: voxc_d4_4_4_5_g4_Ray, traversal: ptr<function,
    voxc_d4_4_4_5_g4_Traversal>, grid: u32) -> bool {
  while (voxc_d4_4_4_5_g4_goes_on(*traversal)) {
    var span: voxc_d4_4_4_5_g4_EmptySpan = voxc_d4_4_4_5_g4_EmptySpan(voxc_d4_4_4_5_g4_LEVEL_1_LOG2_CELL, 1);
    let value = voxc_d4_4_4_5_g4_look_up_level_1(volume, grid,
        (*traversal).cell >> vec3<u32>(u32(voxc_d4_4_4_5_g4_LEVEL_1_LOG2_CELL)), &span);
    if (value == 0u) {
      voxc_d4_4_4_5_g4_march_level_1(ray, traversal, span.count);
    } else if (voxc_d4_4_4_5_g4_intersect_level_2(volume, ray, traversal, value)) {
      return true;
    }
  }
  return false;
}

// What a voxel is: here its value is its colour.
fn voxc_d4_4_4_5_g4_colour_of(volume: u32, traversal: voxc_d4_4_4_5_g4_Traversal) -> u32 {
  return voxc_d4_4_4_5_g4_load_word(volume, traversal.voxel);
}

