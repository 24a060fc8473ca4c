// ${prefix}*: rays through volumes of the format ${FORMAT}, as functions for GLSL ES 3.00, the language of WebGL 2.
//
%if bounded
//     bool ${prefix}closest(VOXC_VOLUME volume, vec3 origin, vec3 direction, float tmin, float tmax, out ${prefix}Hit hit)
//     bool ${prefix}next(VOXC_VOLUME volume, vec3 origin, vec3 direction, float tmax, inout ${prefix}Hit hit)
//     bool ${prefix}any(VOXC_VOLUME volume, vec3 origin, vec3 direction, float tmin, float tmax)
%else
//     bool ${prefix}first(VOXC_VOLUME volume, vec3 origin, vec3 direction, out ${prefix}Hit hit)
%end
//     vec3 ${prefix}normal(const ${prefix}Hit hit)
//     vec3 ${prefix}outside(vec3 origin, vec3 direction, const ${prefix}Hit hit)
//
%if paged
// A volume is what you take for one, and some of its words are here: before this text, say its type, and how a word is found.
//
//     #define VOXC_VOLUME int
//     #define VOXC_FIND(volume, index, word) find(index, word) // bool find(uint index, out uint word)
//
%else
// A volume is what you take for one: before this text, say its type, and how a word of it is loaded. Words in an integer texture:
//
//     uniform highp usampler2D words; // R32UI, 4096 words a row.
//     #define VOXC_VOLUME int
//     #define VOXC_LOAD(volume, index) texelFetch(words, ivec2(int((index) & 4095u), int((index) >> 12)), 0).x
//
%end
// Rays are in voxels; a direction may have any length, and t counts in it. All that this text leaves behind has a name that begins
// with ${prefix} or ${PREFIX}.

// The digest ${DIGEST} of the format's storage, its low half and its high one. The words of a volume are for these functions
// if its digest, which `voxc info` prints, equals this one, and else lead anywhere.
#define ${PREFIX}STORAGE_DIGEST ${digest-halves}
%if paged
#if !defined(VOXC_VOLUME) || !defined(VOXC_FIND)
#error define VOXC_VOLUME as the type of a volume and VOXC_FIND(volume, index, word) as whether a word of one is here
#endif
%else
#if !defined(VOXC_VOLUME) || !defined(VOXC_LOAD)
#error define VOXC_VOLUME as the type of a volume and VOXC_LOAD(volume, index) as a word of one
#endif
%end
#define VOXC_INDEX uint

precision highp float;
precision highp int;
