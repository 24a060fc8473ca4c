uint32_t construct_level_${N}(Build &build, Voxel low) {
%if shares-sub-volumes-apart
  build.forget(${N});
%end
  return root_level_${N}(build, construct_level_${N}_node(build, low, LEVEL_${N}_LAYERS));
}
