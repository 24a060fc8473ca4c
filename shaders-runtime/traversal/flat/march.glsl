// Steps by the distance of a cell of this level, or of those below, if one ended the way down. Then nothing is left to step over.
void march_layer_level(const Ray ray, inout Traversal traversal, const EmptySpan span, int layer, inout bool is_empty) {
  if (LEVEL_MARCHES) {
    if (is_empty && layer == LEVEL_BEGIN)
      march_level(ray, traversal, span.count);
    is_empty = is_empty && layer != LEVEL_BEGIN;
  }
  if (!LEVEL_LAST)
    march_layer_next(ray, traversal, span, layer, is_empty);
}
