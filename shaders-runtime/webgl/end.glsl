
#undef VOXC_INDEX
