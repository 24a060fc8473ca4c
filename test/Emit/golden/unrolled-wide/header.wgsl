// ---- The format: G(4, 2) G(2) ----

// Which child of a node a place lies in, counted in children.
fn voxc_g4_2_g2_child_index(place: vec3<i32>) -> i32 {
  let bits = place & vec3<i32>(1);
  return bits.x | (bits.y << 1u) | (bits.z << 2u);
}

// The same where a node has 4 x 4 x 4 children, in Morton order.
fn voxc_g4_2_g2_child_index_of_64(place: vec3<i32>) -> i32 {
  let bits = (place & vec3<i32>(1)) | ((place & vec3<i32>(2)) << vec3<u32>(2u));
  return bits.x | (bits.y << 1u) | (bits.z << 2u);
}

// The field of so many bits, 32 at most, whose first is that bit of those from a word of `begin` on.
fn voxc_g4_2_g2_load_field_at(volume: u32, place: u32, first: u32, bits: u32) -> u32 {
  let low = voxc_g4_2_g2_load_word(volume, place + (first >> 5u));
  let high = voxc_g4_2_g2_load_word(volume, place + (first >> 5u) + 1u);
  let word = (low >> (first & 31u)) | ((high << 1u) << (31u - (first & 31u)));
  return select(word & ((1u << bits) - 1u), word, bits == 32u);
}

// Field i of those of so many bits that begin at a word.
fn voxc_g4_2_g2_load_field(volume: u32, place: u32, i: u32, bits: u32) -> u32 {
  return voxc_g4_2_g2_load_field_at(volume, place, i * bits, bits);
}

// The rank of a voxel is how many voxels of the volume come before it. Each level counts those of one of its
// sub-volumes that do; of a place without a voxel, those before the least node around that has some.

// Every third bit of a word, the lowest first.
fn voxc_g4_2_g2_spread_bits(given_bits: u32) -> u32 {
  var bits: u32 = given_bits;
  bits = (bits | (bits << 16u)) & 0x030000ffu;
  bits = (bits | (bits << 8u)) & 0x0300f00fu;
  bits = (bits | (bits << 4u)) & 0x030c30c3u;
  return (bits | (bits << 2u)) & 0x09249249u;
}

// The place of a cell, in Morton order, within the aligned cube of 2^log2_side cells a side around it, of 2^10 at most.
fn voxc_g4_2_g2_place_in_cube(cell: vec3<i32>, log2_side: i32) -> u32 {
  let at = cell & vec3<i32>((1 << u32(log2_side)) - 1);
  return voxc_g4_2_g2_spread_bits(u32(at.x)) | (voxc_g4_2_g2_spread_bits(u32(at.y)) << 1u)
      | (voxc_g4_2_g2_spread_bits(u32(at.z)) << 2u);
}

// Level 2: svdag, 4 x 4 x 4 cells of 1 voxel a side.
const voxc_g4_2_g2_LEVEL_2_LOG2_CELL: i32 = 0;
const voxc_g4_2_g2_LEVEL_2_LOG2_SIDE: i32 = 2;

// What the slot of a child leads to that comes behind so many children of its node, of which so many are leaves. Adds
// to `rank` how many voxels these have and, of a leaf, how many of its own come before the cell.
fn voxc_g4_2_g2_ranked_slot_level_2(volume: u32, node: u32, cell: vec3<i32>, height: i32, children: i32, leaves: i32,
    leaf: bool, rank: ptr<function, u32>) -> u32 {
  *rank += u32(leaves) << u32(3 * height);
  let slots = children - leaves;
  let slot = node + 1u + 2u * u32(slots);
  var before: u32;
  if (slots > 0) {
    before = voxc_g4_2_g2_load_word(volume, slot - 1u);
  } else {
    before = 0u;
  }
  *rank += before;
  if (leaf) {
    *rank += voxc_g4_2_g2_place_in_cube(cell, height);
  }
  if (leaf) {
    return node;
  }
  return voxc_g4_2_g2_load_word(volume, slot);
}

// A node is [masks, slots of its children...]: a bit for each child that is not empty, one for each that is a leaf, and
// slots of those that are not empty or, where all leaves have one value, that are neither empty nor leaves. Gives the
// child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
fn voxc_g4_2_g2_child_level_2(volume: u32, node: u32, cell: vec3<i32>, height: i32, leaf: ptr<function, bool>) -> u32 {
  let child = voxc_g4_2_g2_child_index(cell >> vec3<u32>(u32(height)));
  var masks: u32 = voxc_g4_2_g2_load_word(volume, node);
  *leaf = ((masks >> u32(8 + child)) & 1u) != 0u;
  if (((masks >> u32(child)) & 1u) == 0u) {
    return 0u;
  }
  if (*leaf) {
    return node; // All leaves are alike, or nothing more is asked of one.
  }
  masks &= ~(masks >> 8u);
  return voxc_g4_2_g2_load_word(volume, node + 1u + 2u * countOneBits(masks & ((1u << u32(child)) - 1u)));
}

// The same, and adds to `rank` how many voxels of the node come before those of the child or, of a leaf, before the one
// in the cell. The second word of a slot says how many the slots up to it have.
fn voxc_g4_2_g2_ranked_child_level_2(volume: u32, node: u32, cell: vec3<i32>, height: i32, rank: ptr<function, u32>,
    leaf: ptr<function, bool>) -> u32 {
  let child = voxc_g4_2_g2_child_index(cell >> vec3<u32>(u32(height)));
  let masks = voxc_g4_2_g2_load_word(volume, node);
  let lower = (1u << u32(child)) - 1u;
  *leaf = ((masks >> u32(8 + child)) & 1u) != 0u;
  if (((masks >> u32(child)) & 1u) == 0u) {
    return 0u;
  }
  let leaves = i32(countOneBits((masks >> 8u) & lower));
  let children = i32(countOneBits(masks & lower));
  return voxc_g4_2_g2_ranked_slot_level_2(volume, node, cell, height, children, leaves, *leaf, rank);
}

// Whether a traversal is still in the sub-volume in which it began.
fn voxc_g4_2_g2_within_level_2(begin: vec3<i32>, cell: vec3<i32>) -> bool {
  return voxc_g4_2_g2_is_same_cube(begin, cell, voxc_g4_2_g2_LEVEL_2_LOG2_SIDE);
}

// Goes along the ray through a node of a layer, counted from the cells, child after child, to the first leaf, or to the
// first node that looks small, if some do; 0 if there is none.
fn voxc_g4_2_g2_seek_level_2_layer_1(volume: u32, ray: voxc_g4_2_g2_Ray, traversal: ptr<function,
    voxc_g4_2_g2_Traversal>, node: u32, leaf: ptr<function, bool>) -> u32 {
  let height = voxc_g4_2_g2_LEVEL_2_LOG2_CELL;
  let begin = (*traversal).cell;
  var found: u32 = 0u;
  *leaf = false;
  while (found == 0u && voxc_g4_2_g2_is_same_cube(begin, (*traversal).cell, height + 1)) {
    let child = voxc_g4_2_g2_child_level_2(volume, node, (*traversal).cell, height, leaf);
    if (child == 0u) {
      voxc_g4_2_g2_step_over_int(ray, traversal, height);
    } else {
      found = child;
    }
  }
  return found;
}

// Goes along the ray through a node of a layer, counted from the cells, child after child, to the first leaf, or to the
// first node that looks small, if some do; 0 if there is none.
fn voxc_g4_2_g2_seek_level_2_layer_2(volume: u32, ray: voxc_g4_2_g2_Ray, traversal: ptr<function,
    voxc_g4_2_g2_Traversal>, node: u32, leaf: ptr<function, bool>) -> u32 {
  let height = voxc_g4_2_g2_LEVEL_2_LOG2_CELL + 1;
  let begin = (*traversal).cell;
  var found: u32 = 0u;
  *leaf = false;
  while (found == 0u && voxc_g4_2_g2_is_same_cube(begin, (*traversal).cell, height + 1)) {
    let child = voxc_g4_2_g2_child_level_2(volume, node, (*traversal).cell, height, leaf);
    let last = (child == 0u) || *leaf;
    if (child == 0u) {
      voxc_g4_2_g2_step_over_int(ray, traversal, height);
    } else if (!last) {
      found = voxc_g4_2_g2_seek_level_2_layer_1(volume, ray, traversal, child, leaf);
    } else {
      found = child;
    }
  }
  return found;
}

fn voxc_g4_2_g2_intersect_level_2(volume: u32, ray: voxc_g4_2_g2_Ray, traversal: ptr<function, voxc_g4_2_g2_Traversal>,
    root: u32) -> bool {
  let begin = (*traversal).cell;
  while (voxc_g4_2_g2_within_level_2(begin, (*traversal).cell)) {
    var leaf: bool;
    let found = voxc_g4_2_g2_seek_level_2_layer_2(volume, ray, traversal, root, &leaf);
    if (found != 0u && voxc_g4_2_g2_intersect_voxel()) {
      return true;
    }
  }
  return false;
}

// Level 1: svdag, 16 x 16 x 16 cells of 4 voxels a side.
const voxc_g4_2_g2_LEVEL_1_BRANCH: i32 = 2;
const voxc_g4_2_g2_LEVEL_1_LOG2_CELL: i32 = 2;

// What the slot of a child leads to that comes behind so many children of its node, of which so many are leaves. Adds
// to `rank` how many voxels these have and, of a leaf, how many of its own come before the cell.
fn voxc_g4_2_g2_ranked_slot_level_1(volume: u32, node: u32, cell: vec3<i32>, height: i32, children: i32, leaf: bool,
    rank: ptr<function, u32>) -> u32 {
  let slots = children;
  let slot = node + 4u + 2u * u32(slots);
  var before: u32;
  if (slots > 0) {
    before = voxc_g4_2_g2_load_word(volume, slot - 1u);
  } else {
    before = 0u;
  }
  *rank += before;
  if (leaf) {
    *rank += voxc_g4_2_g2_place_in_cube(cell, height) * ((voxc_g4_2_g2_load_word(volume,
        slot + 1u) - before) >> u32(3 * height));
  }
  return voxc_g4_2_g2_load_word(volume, slot);
}

// A node is [mask of children, mask of leaves, slots of its children...], masks of 64 bits. Slots are of those that are
// not empty or, where all leaves have one value, that are neither empty nor leaves. Gives the child of a node that a
// cell lies in, or 0 if it is empty; the child has 2^height cells a side. `around` is 1 if so are the seven that make a
// cube with it.
fn voxc_g4_2_g2_child_level_1(volume: u32, node: u32, cell: vec3<i32>, height: i32, leaf: ptr<function, bool>,
    around: ptr<function, i32>) -> u32 {
  let child = voxc_g4_2_g2_child_index_of_64(cell >> vec3<u32>(u32(height)));
  let half_mask = voxc_g4_2_g2_load_word(volume, node + u32(child >> 5u));
  let bit = 1u << u32(child & 31);
  *around = select(0, 1, ((half_mask >> u32(child & 24)) & 255u) == 0u);
  *leaf = (voxc_g4_2_g2_load_word(volume, node + 2u + u32(child >> 5u)) & bit) != 0u;
  if ((half_mask & bit) == 0u) {
    return 0u;
  }
  var rank: i32 = i32(countOneBits(half_mask & (bit - 1u)));
  if (child >= 32) {
    rank += i32(countOneBits(voxc_g4_2_g2_load_word(volume, node)));
  }
  return voxc_g4_2_g2_load_word(volume, node + 4u + 2u * u32(rank));
}

// The same, and adds to `rank` how many voxels of the node come before those of the child or, of a leaf, before the one
// in the cell. The second word of a slot says how many the slots up to it have.
fn voxc_g4_2_g2_ranked_child_level_1(volume: u32, node: u32, cell: vec3<i32>, height: i32, rank: ptr<function, u32>,
    leaf: ptr<function, bool>) -> u32 {
  let child = voxc_g4_2_g2_child_index_of_64(cell >> vec3<u32>(u32(height)));
  let half_mask = voxc_g4_2_g2_load_word(volume, node + u32(child >> 5u));
  let half_leaves = voxc_g4_2_g2_load_word(volume, node + 2u + u32(child >> 5u));
  let bit = 1u << u32(child & 31);
  let lower = bit - 1u;
  *leaf = (half_leaves & bit) != 0u;
  if ((half_mask & bit) == 0u) {
    return 0u;
  }
  var leaves: i32 = i32(countOneBits(half_leaves & lower));
  var children: i32 = i32(countOneBits(half_mask & lower));
  if (child >= 32) {
    leaves += i32(countOneBits(voxc_g4_2_g2_load_word(volume, node + 2u)));
    children += i32(countOneBits(voxc_g4_2_g2_load_word(volume, node)));
  }
  return voxc_g4_2_g2_ranked_slot_level_1(volume, node, cell, height, children, *leaf, rank);
}

// Goes along the ray through a node of a layer, counted from the cells, child after child, to the first leaf, or to the
// first node that looks small, if some do; 0 if there is none.
fn voxc_g4_2_g2_seek_level_1_layer_1(volume: u32, ray: voxc_g4_2_g2_Ray, traversal: ptr<function,
    voxc_g4_2_g2_Traversal>, node: u32, leaf: ptr<function, bool>) -> u32 {
  let height = voxc_g4_2_g2_LEVEL_1_LOG2_CELL;
  let begin = (*traversal).cell;
  var found: u32 = 0u;
  *leaf = false;
  while (found == 0u && voxc_g4_2_g2_is_same_cube(begin, (*traversal).cell, height + voxc_g4_2_g2_LEVEL_1_BRANCH)) {
    var around: i32 = 0;
    let child = voxc_g4_2_g2_child_level_1(volume, node, (*traversal).cell, height, leaf, &around);
    if (child == 0u) {
      voxc_g4_2_g2_step_over_int(ray, traversal, height + around);
    } else {
      found = child;
    }
  }
  return found;
}

// Goes along the ray through a node of a layer, counted from the cells, child after child, to the first leaf, or to the
// first node that looks small, if some do; 0 if there is none.
fn voxc_g4_2_g2_seek_level_1_layer_2(volume: u32, ray: voxc_g4_2_g2_Ray, traversal: ptr<function,
    voxc_g4_2_g2_Traversal>, node: u32, leaf: ptr<function, bool>) -> u32 {
  let height = voxc_g4_2_g2_LEVEL_1_LOG2_CELL + voxc_g4_2_g2_LEVEL_1_BRANCH;
  let begin = (*traversal).cell;
  var found: u32 = 0u;
  *leaf = false;
  while (found == 0u && voxc_g4_2_g2_is_same_cube(begin, (*traversal).cell, height + voxc_g4_2_g2_LEVEL_1_BRANCH)) {
    var around: i32 = 0;
    let child = voxc_g4_2_g2_child_level_1(volume, node, (*traversal).cell, height, leaf, &around);
    let last = (child == 0u) || *leaf;
    if (child == 0u) {
      voxc_g4_2_g2_step_over_int(ray, traversal, height + around);
    } else if (!last) {
      found = voxc_g4_2_g2_seek_level_1_layer_1(volume, ray, traversal, child, leaf);
    } else {
      found = child;
    }
  }
  return found;
}

fn voxc_g4_2_g2_intersect_level_1(volume: u32, ray: voxc_g4_2_g2_Ray, traversal: ptr<function, voxc_g4_2_g2_Traversal>,
    root: u32) -> bool {
  while (voxc_g4_2_g2_goes_on(*traversal)) {
    var leaf: bool;
    let found = voxc_g4_2_g2_seek_level_1_layer_2(volume, ray, traversal, root, &leaf);
    if (found != 0u && voxc_g4_2_g2_intersect_level_2(volume, ray, traversal, voxc_g4_2_g2_load_word(volume, found))) {
      return true;
    }
  }
  return false;
}

// How many voxels of the tree come before one.
fn voxc_g4_2_g2_rank_level_2(volume: u32, root: u32, voxel: vec3<i32>) -> u32 {
  let at = voxel >> vec3<u32>(u32(voxc_g4_2_g2_LEVEL_2_LOG2_CELL));
  var node: u32 = root;
  var rank: u32 = 0u;
  var leaf: bool = false;
  if (node != 0u && !leaf) {
    node = voxc_g4_2_g2_ranked_child_level_2(volume, node, at, 1, &rank, &leaf);
  }
  if (node != 0u && !leaf) {
    node = voxc_g4_2_g2_ranked_child_level_2(volume, node, at, 0, &rank, &leaf);
  }
  // All that come before it are counted, in this level.
  return rank;
}

// How many voxels of the tree come before one.
fn voxc_g4_2_g2_rank_level_1(volume: u32, root: u32, voxel: vec3<i32>) -> u32 {
  let at = voxel >> vec3<u32>(u32(voxc_g4_2_g2_LEVEL_1_LOG2_CELL));
  var node: u32 = root;
  var rank: u32 = 0u;
  var leaf: bool = false;
  if (node != 0u && !leaf) {
    node = voxc_g4_2_g2_ranked_child_level_1(volume, node, at, voxc_g4_2_g2_LEVEL_1_BRANCH, &rank, &leaf);
  }
  if (node != 0u && !leaf) {
    node = voxc_g4_2_g2_ranked_child_level_1(volume, node, at, 0, &rank, &leaf);
  }
  // All that come before it are counted, in this level.
  if (node == 0u) {
    return rank;
  }
  return rank + voxc_g4_2_g2_rank_level_2(volume, voxc_g4_2_g2_load_word(volume, node), voxel);
}

// The values of voxels, by rank. Word 1 of the volume says where they begin: with a word for each block of 128, where
// that begins, then the blocks. A block is
//   the least of each channel;
//   4 bits a channel, how many bits it takes; DIFFERENCES; RUNS; the bits of an index; the word where the items begin;
//   with RUNS, 128 bits, set where a value is not that before it;
//   for each value, or run, the index of its item, if that has bits; the items.
const voxc_g4_2_g2_LOG2_BLOCK: u32 = 7u;
const voxc_g4_2_g2_DIFFERENCES: u32 = 1u << 16u; // R and B are told as their differences from G.
const voxc_g4_2_g2_RUNS: u32 = 1u << 17u;
const voxc_g4_2_g2_INDEX_SHIFT: u32 = 18u;
const voxc_g4_2_g2_ITEMS_SHIFT: u32 = 24u;
const voxc_g4_2_g2_HEAD_WORDS: u32 = 2u;
const voxc_g4_2_g2_RUN_WORDS: u32 = 4u;

// How many of the bits at a word are set, up to bit i of the four words.
fn voxc_g4_2_g2_runs_until(volume: u32, place: u32, i: u32) -> u32 {
  let last = i >> 5u;
  var begun: u32 = 0u;
  if (last > 0u) {
    begun += countOneBits(voxc_g4_2_g2_load_word(volume, place));
  }
  if (last > 1u) {
    begun += countOneBits(voxc_g4_2_g2_load_word(volume, place + 1u));
  }
  if (last > 2u) {
    begun += countOneBits(voxc_g4_2_g2_load_word(volume, place + 2u));
  }
  return begun + countOneBits(voxc_g4_2_g2_load_word(volume, place + last) & (0xffffffffu >> (31u - (i & 31u))));
}

// A channel, whose bits begin at `shift` of an item and, in the head, 4 * channel up.
fn voxc_g4_2_g2_channel_of(item: u32, shift: u32, least: u32, head: u32, channel: u32) -> u32 {
  let bits = (head >> (4u * channel)) & 15u;
  return (((item >> shift) & ((1u << bits) - 1u)) + (least >> (8u * channel))) & 255u;
}

fn voxc_g4_2_g2_value_of_item(item: u32, least: u32, head: u32) -> u32 {
  let g_at = head & 15u;
  let b_at = g_at + ((head >> 4u) & 15u);
  let a_at = b_at + ((head >> 8u) & 15u);
  let r = voxc_g4_2_g2_channel_of(item, 0u, least, head, 0u);
  let g = voxc_g4_2_g2_channel_of(item, g_at, least, head, 1u);
  let b = voxc_g4_2_g2_channel_of(item, b_at, least, head, 2u);
  let a = voxc_g4_2_g2_channel_of(item, a_at, least, head, 3u);
  let from_ = select(0u, g, (head & voxc_g4_2_g2_DIFFERENCES) != 0u);
  return ((r + from_) & 255u) | (g << 8u) | (((b + from_) & 255u) << 16u) | (a << 24u);
}

// The value of the voxel of a rank.
fn voxc_g4_2_g2_value_of_rank(volume: u32, rank: u32) -> u32 {
  let section = voxc_g4_2_g2_load_word(volume, 1u);
  let block = section + voxc_g4_2_g2_load_word(volume, section + (rank >> voxc_g4_2_g2_LOG2_BLOCK));
  let least = voxc_g4_2_g2_load_word(volume, block);
  let head = voxc_g4_2_g2_load_word(volume, block + 1u);
  var i: u32 = rank & ((1u << voxc_g4_2_g2_LOG2_BLOCK) - 1u);
  var fields: u32 = block + voxc_g4_2_g2_HEAD_WORDS;
  if ((head & voxc_g4_2_g2_RUNS) != 0u) {
    i = voxc_g4_2_g2_runs_until(volume, fields, i) - 1u;
    fields += voxc_g4_2_g2_RUN_WORDS;
  }
  let index_bits = (head >> voxc_g4_2_g2_INDEX_SHIFT) & 15u;
  if (index_bits != 0u) {
    i = voxc_g4_2_g2_load_field(volume, fields, i, index_bits);
  }
  let bits = (head & 15u) + ((head >> 4u) & 15u) + ((head >> 8u) & 15u) + ((head >> 12u) & 15u);
  // Items without bits take no words, and a field is read with the word behind it: behind the last block is one word
  // alone.
  let items = select(0u, head >> voxc_g4_2_g2_ITEMS_SHIFT, bits != 0u);
  return voxc_g4_2_g2_value_of_item(voxc_g4_2_g2_load_field(volume, block + items, i, bits), least, head);
}

// What a voxel is: here its value is its colour.
fn voxc_g4_2_g2_colour_of(volume: u32, traversal: voxc_g4_2_g2_Traversal) -> u32 {
  return voxc_g4_2_g2_value_of_rank(volume, voxc_g4_2_g2_rank_level_1(volume, voxc_g4_2_g2_load_word(volume, 0u),
      traversal.cell));
}

