uint32_t construct_level_${N}(Build &build, Voxel low) {
%if shares-sub-volumes-apart
  build.forget(${N});
%end
  return construct_level_${N}_node(build, low, LEVEL_${N}_LAYERS).value; // Which is no leaf, if it is anything.
}
