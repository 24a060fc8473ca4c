// The layer of the lowest node, of this level and those below, that has both cells of a step. Their numbers differ in no bit above
// the highest.
int common_layer_level(int highest, const Lowest lowest) {
  int layer = LEVEL_BEGIN;
  if (LEVEL_HAS_LAYERS)
    layer =
        min(LEVEL_BEGIN + (LEVEL_LOG2_SIDE - 1 - highest) / LEVEL_BRANCH, LEVEL_LAST ? LEVEL_END - 1 : lowest.layer[LEVEL_INDEX]);
  return !LEVEL_LAST && highest < LEVEL_LOG2_CELL ? common_layer_next(highest, lowest) : layer;
}
