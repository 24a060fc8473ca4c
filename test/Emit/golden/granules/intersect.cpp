  // ---- The format: R(3, 3, 3) R(3, 3, 3) ----

  // Level 2: raw, 8 x 8 x 8 cells of 1 voxel a side.
  static inline const ivec3 LEVEL_2_LOG2_SIZE = ivec3(3, 3, 3);
  static inline const int LEVEL_2_LOG2_CELL = 0;
  static inline const int LEVEL_2_LOG2_SIDE = 3;

  // The granule in which a cell's slot is.
  uint granule_level_2(uint grid, ivec3 cell) {
    ivec3 at = cell & ((ivec3(1) << LEVEL_2_LOG2_SIZE) - 1);
    int granule = at.x >> 1 | at.y << 2 | at.z << 5;
    return grid + uint(granule);
  }

  // A grid has a slot a cell, x fastest, then y, then z.
  // The place of a cell's slot: in that granule, where references count granules.
  uint slot_level_2(ivec3 cell) {
    ivec3 at = cell & ((ivec3(1) << LEVEL_2_LOG2_SIZE) - 1);
    int slot = at.x & 1;
    return uint(slot);
  }

  // The value of a cell, or 0 if it is empty.
  uint cell_level_2(uint grid, ivec3 cell) {
    uint granule = granule_level_2(grid, cell);
    uint slot = slot_level_2(cell);
    return load_word(granule, slot);
  }

  // Whether a traversal is still in the sub-volume in which it began.
  bool within_level_2(ivec3 begin, ivec3 cell) { return is_same_cube(begin, cell, LEVEL_2_LOG2_SIDE); }

  bool intersect_level_2(const Ray &ray, Traversal &traversal, uint grid) {
    ivec3 begin = traversal.cell;
    while (within_level_2(begin, traversal.cell)) {
      count_lookup(traversal);
      uint value = cell_level_2(grid, traversal.cell >> LEVEL_2_LOG2_CELL);
      if (value == 0u) {
        step_over_voxel(ray, traversal);
      } else if (intersect_voxel(traversal, value)) {
        return true;
      }
    }
    return false;
  }

  // Level 1: raw, 8 x 8 x 8 cells of 8 voxels a side.
  static inline const int LEVEL_1_LOG2_CELL = 3;

  // The granule in which a cell's slot is.
  uint granule_level_1(uint grid, ivec3 cell) {
    ivec3 at = cell;
    int granule = at.x >> 1 | at.y << 2 | at.z << 5;
    return grid + uint(granule);
  }

  // A grid has a slot a cell, x fastest, then y, then z.
  // The place of a cell's slot: in that granule, where references count granules.
  uint slot_level_1(ivec3 cell) {
    ivec3 at = cell;
    int slot = at.x & 1;
    return uint(slot);
  }

  // The value of a cell, or 0 if it is empty.
  uint cell_level_1(uint grid, ivec3 cell) {
    uint granule = granule_level_1(grid, cell);
    uint slot = slot_level_1(cell);
    return load_word(granule, slot);
  }

  bool intersect_level_1(const Ray &ray, Traversal &traversal, uint grid) {
    while (goes_on(traversal)) {
      count_lookup(traversal);
      EmptySpan span = EmptySpan(LEVEL_1_LOG2_CELL, 1);
      uint value = cell_level_1(grid, traversal.cell >> LEVEL_1_LOG2_CELL);
      if (value == 0u) {
        step_over(ray, traversal, span);
      } else if (intersect_level_2(ray, traversal, value)) {
        return true;
      }
    }
    return false;
  }

  // What a voxel is: here its value is its colour.
  uint colour_of(const Traversal &traversal) { return traversal.voxel; }

