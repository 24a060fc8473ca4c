uint32_t construct_level_${N}(Build &build, Voxel low) {
  const Node root = construct_level_${N}_node(build, low, LEVEL_${N}_LAYERS);
  if (root.kind == Node::Empty)
    return 0;
  constexpr int kMasks = mask_words(LEVEL_${N}_CHILDREN);
  uint32_t record[1 + kMasks] = {root.value};
  for (int i = 0; i < kMasks; ++i)
    record[1 + i] = root.masks[i];
  return build.append(${N}, record, 1 + kMasks);
}
