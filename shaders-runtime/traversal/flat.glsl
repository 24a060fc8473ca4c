// All levels in one loop. path[i] is the node in layer i around the traversal's cell, counted from the root through all levels; a
// step climbs only to the lowest node that has the old cell and the new.
bool intersect_level_1(const Ray ray, inout Traversal traversal, uint root) {
  uint path[LAYERS];
  path[0] = root;
  int layer = 0;
  Lowest lowest;
  if (KEEPS_LOWEST) {
    [[unroll]] for (int i = 0; i < LEVELS; i++)
      lowest.layer[i] = 0;
  }
  while (goes_on(traversal)) {
    // Down to a voxel, or to the empty span around the cell.
    count_lookup(traversal);
    uint node = path[layer];
    uint value = 0u;
    EmptySpan span = EmptySpan(0, 1);
    while (node != 0u) {
      path[layer] = node;
      look_up_layer_level_1(ray, traversal.cell, node, layer, lowest, span, value);
    }
    if (COLOUR && value != 0u) {
      traversal.voxel = value;
      return true;
    }
    if (!COLOUR && value != 0u)
      return true;
    ivec3 before = traversal.cell;
    bool is_empty = node == 0u && (!LOOK_UPS_MAY_BE_CUT || span.count > 0); // Else the device ended the loop above, or one in it.
    march_layer_level_1(ray, traversal, span, layer, is_empty);
    if (is_empty)
      step_over(ray, traversal, span);
    ivec3 changed = before ^ traversal.cell;
    int highest = findMSB(uint(changed.x | changed.y | changed.z));
    layer = min(layer, common_layer_level_1(highest, lowest));
  }
  return false;
}
