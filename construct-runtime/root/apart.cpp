// What leads to a sub-volume of this root. One of a single cell is a leaf.
uint32_t root_level_${N}(Build &build, const Node &root) {
  return root.kind == Node::Leaf ? build.intern_leaf(${N}, root.value) : root.value;
}
