  // ---- The format: G(4, 2) G(2) ----

  // Which child of a node a place lies in, counted in children.
  int child_index(ivec3 place) {
    ivec3 bits = place & 1;
    return bits.x | bits.y << 1 | bits.z << 2;
  }

  // The same where a node has 4 x 4 x 4 children, in Morton order.
  int child_index_of_64(ivec3 place) {
    ivec3 bits = (place & 1) | (place & 2) << 2;
    return bits.x | bits.y << 1 | bits.z << 2;
  }

  // The field of so many bits, 32 at most, whose first is that bit of those from a word of `begin` on.
  uint load_field_at(uint place, uint first, uint bits) {
    uint low = load_word(place + (first >> 5));
    uint high = load_word(place + (first >> 5) + 1u);
    uint word = low >> (first & 31u) | (high << 1) << (31u - (first & 31u));
    return bits == 32u ? word : word & ((1u << bits) - 1u);
  }

  // Field i of those of so many bits that begin at a word.
  uint load_field(uint place, uint i, uint bits) { return load_field_at(place, i * bits, bits); }

  // The rank of a voxel is how many voxels of the volume come before it. Each level counts those of one of its
  // sub-volumes that do; of a place without a voxel, those before the least node around that has some.

  // Every third bit of a word, the lowest first.
  uint spread_bits(uint bits) {
    bits = (bits | bits << 16) & 0x030000ffu;
    bits = (bits | bits << 8) & 0x0300f00fu;
    bits = (bits | bits << 4) & 0x030c30c3u;
    return (bits | bits << 2) & 0x09249249u;
  }

  // The place of a cell, in Morton order, within the aligned cube of 2^log2_side cells a side around it, of 2^10 at most.
  uint place_in_cube(ivec3 cell, int log2_side) {
    ivec3 at = cell & ((1 << log2_side) - 1);
    return spread_bits(uint(at.x)) | spread_bits(uint(at.y)) << 1 | spread_bits(uint(at.z)) << 2;
  }

  // Level 2: svdag, 4 x 4 x 4 cells of 1 voxel a side.
  static inline const int LEVEL_2_LOG2_CELL = 0;
  static inline const int LEVEL_2_LOG2_SIDE = 2;

  // What the slot of a child leads to that comes behind so many children of its node, of which so many are leaves. Adds
  // to `rank` how many voxels these have and, of a leaf, how many of its own come before the cell.
  uint ranked_slot_level_2(uint node, ivec3 cell, int height, int children, int leaves, bool leaf, uint &rank) {
    rank += uint(leaves) << (3 * height);
    int slots = children - leaves;
    uint slot = node + 1u + 2u * uint(slots);
    uint before = slots > 0 ? load_word(slot - 1u) : 0u;
    rank += before;
    if (leaf)
      rank += place_in_cube(cell, height);
    return leaf ? node : load_word(slot);
  }

  // A node is [masks, slots of its children...]: a bit for each child that is not empty, one for each that is a leaf, and
  // slots of those that are not empty or, where all leaves have one value, that are neither empty nor leaves. Gives the
  // child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
  uint child_level_2(uint node, ivec3 cell, int height, bool &leaf) {
    int child = child_index(cell >> height);
    uint masks = load_word(node);
    leaf = (masks >> (8 + child) & 1u) != 0u;
    if ((masks >> child & 1u) == 0u)
      return 0u;
    if (leaf)
      return node; // All leaves are alike, or nothing more is asked of one.
    masks &= ~(masks >> 8);
    return load_word(node + 1u + 2u * uint(bitCount(masks & ((1u << child) - 1u))));
  }

  // The same, and adds to `rank` how many voxels of the node come before those of the child or, of a leaf, before the one
  // in the cell. The second word of a slot says how many the slots up to it have.
  uint ranked_child_level_2(uint node, ivec3 cell, int height, uint &rank, bool &leaf) {
    int child = child_index(cell >> height);
    uint masks = load_word(node);
    uint lower = (1u << child) - 1u;
    leaf = (masks >> (8 + child) & 1u) != 0u;
    if ((masks >> child & 1u) == 0u)
      return 0u;
    int leaves = bitCount(masks >> 8 & lower);
    int children = bitCount(masks & lower);
    return ranked_slot_level_2(node, cell, height, children, leaves, leaf, rank);
  }

  // Whether a traversal is still in the sub-volume in which it began.
  bool within_level_2(ivec3 begin, ivec3 cell) { return is_same_cube(begin, cell, LEVEL_2_LOG2_SIDE); }

  // Goes along the ray through a node of a layer, counted from the cells, child after child, to the first leaf, or to the
  // first node that looks small, if some do; 0 if there is none.
  uint seek_level_2_layer_1(const Ray &ray, Traversal &traversal, uint node, bool &leaf) {
    const int height = LEVEL_2_LOG2_CELL;
    ivec3 begin = traversal.cell;
    uint found = 0u;
    leaf = false;
    while (found == 0u && is_same_cube(begin, traversal.cell, height + 1)) {
      uint child = child_level_2(node, traversal.cell, height, leaf);
      bool last = true;
      if (last)
        count_lookup(traversal);
      if (child == 0u)
        step_over(ray, traversal, height);
      else
        found = child;
    }
    return found;
  }

  // Goes along the ray through a node of a layer, counted from the cells, child after child, to the first leaf, or to the
  // first node that looks small, if some do; 0 if there is none.
  uint seek_level_2_layer_2(const Ray &ray, Traversal &traversal, uint node, bool &leaf) {
    const int height = LEVEL_2_LOG2_CELL + 1;
    ivec3 begin = traversal.cell;
    uint found = 0u;
    leaf = false;
    while (found == 0u && is_same_cube(begin, traversal.cell, height + 1)) {
      uint child = child_level_2(node, traversal.cell, height, leaf);
      bool last = child == 0u || leaf;
      if (last)
        count_lookup(traversal);
      if (child == 0u)
        step_over(ray, traversal, height);
      else if (!last)
        found = seek_level_2_layer_1(ray, traversal, child, leaf);
      else
        found = child;
    }
    return found;
  }

  bool intersect_level_2(const Ray &ray, Traversal &traversal, uint root) {
    ivec3 begin = traversal.cell;
    while (within_level_2(begin, traversal.cell)) {
      bool leaf;
      uint found = seek_level_2_layer_2(ray, traversal, root, leaf);
      if (found != 0u && intersect_voxel(traversal, found))
        return true;
    }
    return false;
  }

  // Level 1: svdag, 16 x 16 x 16 cells of 4 voxels a side.
  static inline const int LEVEL_1_BRANCH = 2;
  static inline const int LEVEL_1_LOG2_CELL = 2;

  // What the slot of a child leads to that comes behind so many children of its node, of which so many are leaves. Adds
  // to `rank` how many voxels these have and, of a leaf, how many of its own come before the cell.
  uint ranked_slot_level_1(uint node, ivec3 cell, int height, int children, bool leaf, uint &rank) {
    int slots = children;
    uint slot = node + 4u + 2u * uint(slots);
    uint before = slots > 0 ? load_word(slot - 1u) : 0u;
    rank += before;
    if (leaf)
      rank += place_in_cube(cell, height) * (load_word(slot + 1u) - before >> (3 * height));
    return load_word(slot);
  }

  // A node is [mask of children, mask of leaves, slots of its children...], masks of 64 bits. Slots are of those that are
  // not empty or, where all leaves have one value, that are neither empty nor leaves. Gives the child of a node that a
  // cell lies in, or 0 if it is empty; the child has 2^height cells a side. `around` is 1 if so are the seven that make a
  // cube with it.
  uint child_level_1(uint node, ivec3 cell, int height, bool &leaf, int &around) {
    int child = child_index_of_64(cell >> height);
    uint half_mask = load_word(node + uint(child >> 5));
    uint bit = 1u << (child & 31);
    around = (half_mask >> (child & 24) & 255u) == 0u ? 1 : 0;
    leaf = (load_word(node + 2u + uint(child >> 5)) & bit) != 0u;
    if ((half_mask & bit) == 0u)
      return 0u;
    int rank = bitCount(half_mask & (bit - 1u));
    if (child >= 32)
      rank += bitCount(load_word(node));
    return load_word(node + 4u + 2u * uint(rank));
  }

  // The same, and adds to `rank` how many voxels of the node come before those of the child or, of a leaf, before the one
  // in the cell. The second word of a slot says how many the slots up to it have.
  uint ranked_child_level_1(uint node, ivec3 cell, int height, uint &rank, bool &leaf) {
    int child = child_index_of_64(cell >> height);
    uint half_mask = load_word(node + uint(child >> 5));
    uint half_leaves = load_word(node + 2u + uint(child >> 5));
    uint bit = 1u << (child & 31);
    uint lower = bit - 1u;
    leaf = (half_leaves & bit) != 0u;
    if ((half_mask & bit) == 0u)
      return 0u;
    int leaves = bitCount(half_leaves & lower);
    int children = bitCount(half_mask & lower);
    if (child >= 32) {
      leaves += bitCount(load_word(node + 2u));
      children += bitCount(load_word(node));
    }
    return ranked_slot_level_1(node, cell, height, children, leaf, rank);
  }

  // Goes along the ray through a node of a layer, counted from the cells, child after child, to the first leaf, or to the
  // first node that looks small, if some do; 0 if there is none.
  uint seek_level_1_layer_1(const Ray &ray, Traversal &traversal, uint node, bool &leaf) {
    const int height = LEVEL_1_LOG2_CELL;
    ivec3 begin = traversal.cell;
    uint found = 0u;
    leaf = false;
    while (found == 0u && is_same_cube(begin, traversal.cell, height + LEVEL_1_BRANCH)) {
      int around = 0;
      uint child = child_level_1(node, traversal.cell, height, leaf, around);
      bool last = true;
      if (last)
        count_lookup(traversal);
      if (child == 0u)
        step_over(ray, traversal, height + around);
      else
        found = child;
    }
    return found;
  }

  // Goes along the ray through a node of a layer, counted from the cells, child after child, to the first leaf, or to the
  // first node that looks small, if some do; 0 if there is none.
  uint seek_level_1_layer_2(const Ray &ray, Traversal &traversal, uint node, bool &leaf) {
    const int height = LEVEL_1_LOG2_CELL + LEVEL_1_BRANCH;
    ivec3 begin = traversal.cell;
    uint found = 0u;
    leaf = false;
    while (found == 0u && is_same_cube(begin, traversal.cell, height + LEVEL_1_BRANCH)) {
      int around = 0;
      uint child = child_level_1(node, traversal.cell, height, leaf, around);
      bool last = child == 0u || leaf;
      if (last)
        count_lookup(traversal);
      if (child == 0u)
        step_over(ray, traversal, height + around);
      else if (!last)
        found = seek_level_1_layer_1(ray, traversal, child, leaf);
      else
        found = child;
    }
    return found;
  }

  bool intersect_level_1(const Ray &ray, Traversal &traversal, uint root) {
    while (goes_on(traversal)) {
      bool leaf;
      uint found = seek_level_1_layer_2(ray, traversal, root, leaf);
      if (found != 0u && intersect_level_2(ray, traversal, load_word(found)))
        return true;
    }
    return false;
  }

  // How many voxels of the tree come before one.
  uint rank_level_2(uint root, ivec3 voxel) {
    ivec3 at = voxel >> LEVEL_2_LOG2_CELL;
    uint node = root;
    uint rank = 0u;
    bool leaf = false;
    if (node != 0u && !leaf)
      node = ranked_child_level_2(node, at, 1, rank, leaf);
    if (node != 0u && !leaf)
      node = ranked_child_level_2(node, at, 0, rank, leaf);
    // All that come before it are counted, in this level.
    return rank;
  }

  // How many voxels of the tree come before one.
  uint rank_level_1(uint root, ivec3 voxel) {
    ivec3 at = voxel >> LEVEL_1_LOG2_CELL;
    uint node = root;
    uint rank = 0u;
    bool leaf = false;
    if (node != 0u && !leaf)
      node = ranked_child_level_1(node, at, LEVEL_1_BRANCH, rank, leaf);
    if (node != 0u && !leaf)
      node = ranked_child_level_1(node, at, 0, rank, leaf);
    // All that come before it are counted, in this level.
    return node == 0u ? rank : rank + rank_level_2(load_word(node), voxel);
  }

  // The values of voxels, by rank. Word 1 of the volume says where they begin: with a word for each block of 128, where
  // that begins, then the blocks. A block is
  //   the least of each channel;
  //   4 bits a channel, how many bits it takes; DIFFERENCES; RUNS; the bits of an index; the word where the items begin;
  //   with RUNS, 128 bits, set where a value is not that before it;
  //   for each value, or run, the index of its item, if that has bits; the items.
  static inline const uint LOG2_BLOCK = 7u;
  static inline const uint DIFFERENCES = 1u << 16; // R and B are told as their differences from G.
  static inline const uint RUNS = 1u << 17;
  static inline const uint INDEX_SHIFT = 18u;
  static inline const uint ITEMS_SHIFT = 24u;
  static inline const uint HEAD_WORDS = 2u;
  static inline const uint RUN_WORDS = 4u;

  // How many of the bits at a word are set, up to bit i of the four words.
  uint runs_until(uint place, uint i) {
    uint last = i >> 5;
    uint begun = 0u;
    if (last > 0u)
      begun += uint(bitCount(load_word(place)));
    if (last > 1u)
      begun += uint(bitCount(load_word(place + 1u)));
    if (last > 2u)
      begun += uint(bitCount(load_word(place + 2u)));
    return begun + uint(bitCount(load_word(place + last) & (0xffffffffu >> (31u - (i & 31u)))));
  }

  // A channel, whose bits begin at `shift` of an item and, in the head, 4 * channel up.
  uint channel_of(uint item, uint shift, uint least, uint head, uint channel) {
    uint bits = head >> (4u * channel) & 15u;
    return (item >> shift & ((1u << bits) - 1u)) + (least >> (8u * channel)) & 255u;
  }

  uint value_of_item(uint item, uint least, uint head) {
    uint g_at = head & 15u;
    uint b_at = g_at + (head >> 4 & 15u);
    uint a_at = b_at + (head >> 8 & 15u);
    uint r = channel_of(item, 0u, least, head, 0u);
    uint g = channel_of(item, g_at, least, head, 1u);
    uint b = channel_of(item, b_at, least, head, 2u);
    uint a = channel_of(item, a_at, least, head, 3u);
    uint from = (head & DIFFERENCES) != 0u ? g : 0u;
    return (r + from & 255u) | g << 8 | (b + from & 255u) << 16 | a << 24;
  }

  // The value of the voxel of a rank.
  uint value_of_rank(uint rank) {
    uint section = load_word(1u);
    uint block = section + load_word(section + (rank >> LOG2_BLOCK));
    uint least = load_word(block);
    uint head = load_word(block + 1u);
    uint i = rank & ((1u << LOG2_BLOCK) - 1u);
    uint fields = block + HEAD_WORDS;
    if ((head & RUNS) != 0u) {
      i = runs_until(fields, i) - 1u;
      fields += RUN_WORDS;
    }
    uint index_bits = head >> INDEX_SHIFT & 15u;
    if (index_bits != 0u)
      i = load_field(fields, i, index_bits);
    uint bits = (head & 15u) + (head >> 4 & 15u) + (head >> 8 & 15u) + (head >> 12 & 15u);
    // Items without bits take no words, and a field is read with the word behind it: behind the last block is one word
    // alone.
    uint items = bits != 0u ? head >> ITEMS_SHIFT : 0u;
    return value_of_item(load_field(block + items, i, bits), least, head);
  }

  // What a voxel is: here its value is its colour.
  uint colour_of(const Traversal &traversal) { return value_of_rank(rank_level_1(load_word(0u), traversal.cell)); }

