uint32_t construct_level_${N}(Build &build, Voxel low) {
%if shares-sub-volumes-apart
  build.forget(${N});
%end
  const Node root = construct_level_${N}_node(build, low, LEVEL_${N}_LAYERS);
  return root.kind == Node::Leaf ? build.intern_leaf(${N}, root.value) : root.value;
}
