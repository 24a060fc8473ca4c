// What leads to a sub-volume of this root, which is no leaf, if it is anything.
uint32_t root_level_${N}(Build &, const Node &root) { return root.value; }
