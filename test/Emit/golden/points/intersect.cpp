  // ---- The format: D(4, 4, 4, 5) G(4) ----

  // Which child of a node a place lies in, counted in children.
  int child_index(ivec3 place) {
    ivec3 bits = place & 1;
    return bits.x | bits.y << 1 | bits.z << 2;
  }

  // Level 2: svdag, 16 x 16 x 16 cells of 1 voxel a side.
  static inline const int LEVEL_2_LOG2_CELL = 0;

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
    return load_word(node + 1u + uint(bitCount(masks & ((1u << child) - 1u))));
  }

  // Whether there is a voxel, in this tree.
  bool is_voxel_level_2(uint root, ivec3 voxel) {
    ivec3 at = voxel >> LEVEL_2_LOG2_CELL;
    uint node = root;
    bool leaf = false;
    if (node != 0u && !leaf)
      node = child_level_2(node, at, 3, leaf);
    if (node != 0u && !leaf)
      node = child_level_2(node, at, 2, leaf);
    if (node != 0u && !leaf)
      node = child_level_2(node, at, 1, leaf);
    if (node != 0u && !leaf)
      node = child_level_2(node, at, 0, leaf);
    return node != 0u;
  }

  // Level 1: distance, 16 x 16 x 16 cells of 16 voxels a side.
  static inline const ivec3 LEVEL_1_LOG2_SIZE = ivec3(4, 4, 4);
  static inline const int LEVEL_1_LOG2_CELL = 4;

  // A grid has a slot a cell, x fastest, then y, then z.
  // The place of a cell's slot: in that granule, where references count granules.
  uint slot_level_1(uint grid, ivec3 cell) {
    ivec3 at = cell;
    return grid + 2u * uint(at.x + ((at.y + (at.z << LEVEL_1_LOG2_SIZE.y)) << LEVEL_1_LOG2_SIZE.x));
  }

  // The value of a cell, or 0 if it is empty.
  uint cell_level_1(uint grid, ivec3 cell) {
    uint slot = slot_level_1(grid, cell);
    return load_word(slot);
  }

  // Whether there is a voxel, in this grid.
  bool is_voxel_level_1(uint grid, ivec3 voxel) {
    uint value = cell_level_1(grid, voxel >> LEVEL_1_LOG2_CELL);
    return value != 0u && is_voxel_level_2(value, voxel);
  }

