
#undef VOXC_IN
#undef VOXC_INOUT
#undef VOXC_OUT
#undef VOXC_FUNCTION
#undef VOXC_SELDOM
#undef VOXC_INDEX
#undef VOXC_PRECISE

#ifdef __cplusplus

#ifdef VOXC_OWN_VOLUME
#undef VOXC_OWN_VOLUME
#undef VOXC_VOLUME
#undef VOXC_LOAD
#endif
#undef VOXC_INLINE
#undef VOXC_CONSTANT
#undef VOXC_DEVICE
#undef VOXC_BUILTIN
#undef VOXC_OPERATOR
#undef OUT_OF_LINE
#undef VOXC_BEGIN_INLINE
#undef VOXC_END_INLINE

} // namespace ${prefix}text

using ${prefix}text::${prefix}Hit;
using ${prefix}text::${prefix}VOLUME_SIZE;
using ${prefix}text::${prefix}any;
using ${prefix}text::${prefix}closest;
using ${prefix}text::${prefix}next;
using ${prefix}text::${prefix}normal;
using ${prefix}text::${prefix}outside;

#endif

#endif
