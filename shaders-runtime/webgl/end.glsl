
#undef VOXC_IN
#undef VOXC_INOUT
#undef VOXC_OUT
#undef VOXC_FUNCTION
#undef VOXC_SELDOM
#undef VOXC_INDEX
#undef VOXC_PRECISE
