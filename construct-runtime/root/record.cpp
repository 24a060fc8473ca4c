// What leads to a sub-volume of this root, which gets a record of its own.
uint32_t root_level_${N}(Build &build, const Node &root) {
  if (root.kind == Node::Empty)
    return 0;
  constexpr int kMasks = mask_words(LEVEL_${N}_CHILDREN);
  uint32_t record[1 + kMasks] = {root.value};
  for (int i = 0; i < kMasks; ++i)
    record[1 + i] = root.masks[i];
  return build.append(${N}, record, 1 + kMasks);
}
