  // ---- The format: S(9) ----

  // Which child of a node a place lies in, counted in children.
  int child_index(ivec3 place) {
    ivec3 bits = place & 1;
    return bits.x | bits.y << 1 | bits.z << 2;
  }

  // Level 1: svo, 512 x 512 x 512 cells of 1 voxel a side.
  static inline const int LEVEL_1_DEPTH = 9;
  static inline const int LEVEL_1_LOG2_CELL = 0;

  // A node of an octree is [first child, masks]; its children that are not empty stand together, two words each.
  // Gives the child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
  uint child_level_1(uint node, ivec3 cell, int height, bool &leaf) {
    int child = child_index(cell >> height);
    uint masks = load_word(node + 1u);
    leaf = (masks >> (8 + child) & 1u) != 0u;
    if ((masks >> child & 1u) == 0u)
      return 0u;
    return load_word(node) + 2u * uint(bitCount(masks & ((1u << child) - 1u)));
  }

  // path[i] is the node i layers above the cells around the traversal's cell: a step climbs only to the ancestor of the
  // old cell and the new.
  bool intersect_level_1(const Ray &ray, Traversal &traversal, uint root) {
    uint path[LEVEL_1_DEPTH + 1];
    path[LEVEL_1_DEPTH] = root;
    int top = LEVEL_1_DEPTH;
    for (;;) {
      // Down to the leaf, or the empty child, `layer` layers above the cells.
      count_lookup(traversal);
      ivec3 cell = traversal.cell >> LEVEL_1_LOG2_CELL;
      uint node = path[top];
      int layer = top;
      bool leaf = false;
      while (node != 0u && !leaf) {
        path[layer] = node;
        layer--;
        node = child_level_1(node, cell, layer, leaf);
      }
      ivec3 before = traversal.cell;
      if (node == 0u)
        step_over(ray, traversal, LEVEL_1_LOG2_CELL + layer);
      else if (leaf && intersect_voxel(traversal, node))
        return true;

      if (!goes_on(traversal))
        return false;
      ivec3 changed = before ^ traversal.cell;
      int highest = findMSB(uint(changed.x | changed.y | changed.z));
      top = max(layer, highest - LEVEL_1_LOG2_CELL) + 1;
    }
  }

  // What a voxel is: here its value is its colour.
  uint colour_of(const Traversal &traversal) { return load_word(traversal.voxel); }

