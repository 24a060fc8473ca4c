// A tree of depth 0 is one leaf.
bool intersect_level_${N}(const Ray ray, inout Walk walk, uint leaf) {
  count_lookup(walk);
%if stops
  if (small_height(ray, walk) >= LEVEL_${N}_LOG2_CELL)
%if colour
    return stop_with(walk, sample_${NEXT}(load_word(leaf)));
%else
    return true;
%end
%end
  return intersect_${NEXT}(ray, walk, ${leaf-leaf});
}
