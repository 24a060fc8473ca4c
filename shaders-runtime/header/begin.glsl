// ${prefix}*: rays through volumes of the format ${FORMAT}, as functions for GLSL 4.50 and for C++20.
//
//     bool ${prefix}closest(VOXC_VOLUME volume, vec3 origin, vec3 direction, float tmin, float tmax, out ${prefix}Hit hit)
//     bool ${prefix}next(VOXC_VOLUME volume, vec3 origin, vec3 direction, float tmax, inout ${prefix}Hit hit)
//     bool ${prefix}any(VOXC_VOLUME volume, vec3 origin, vec3 direction, float tmin, float tmax)
//     vec3 ${prefix}normal(const ${prefix}Hit hit)
//     vec3 ${prefix}outside(vec3 origin, vec3 direction, const ${prefix}Hit hit)
//
// A volume is what you take for one: before you include this, say its type, and how a word of it is loaded.
//
//     layout(std430, binding = 0) readonly buffer Volumes { uint words[]; } volumes[8];
//     #define VOXC_VOLUME uint
//     #define VOXC_LOAD(volume, index) volumes[volume].words[index]
//
// In C++ a volume is a pointer to its words, if you say nothing else. Rays are in voxels; a direction may have any length, and t
// counts in it. All that this text leaves behind has a name that begins with ${prefix} or ${PREFIX}.
#ifndef ${PREFIX}H
#define ${PREFIX}H

// The digest of the format's storage. The words of a volume are for these functions if its digest equals this one, and else lead
// anywhere: compare it with Volume::storageDigest() in C++, voxc_volume_digest() in C, Volume.digest in Python, or the digest that
// `voxc info` prints. In GLSL it is the low half and the high one.
#ifdef __cplusplus
#define ${PREFIX}FORMAT "${FORMAT}"
#define ${PREFIX}STORAGE_DIGEST ${DIGEST}ull
#else
#define ${PREFIX}STORAGE_DIGEST ${digest-halves}
#endif

#ifdef __cplusplus
#pragma GCC system_header // No warnings: what a format has no use for stands here all the same.

// GLSL's vectors and built-in functions in C++.
namespace ${prefix}text {
${glsl-in-cpp}
using namespace voxc::glsl;

#define VOXC_IN(type) const type &
#define VOXC_INOUT(type) type &
#define VOXC_OUT(type) type &
#define VOXC_FUNCTION static inline
#define VOXC_SELDOM [[gnu::noinline, gnu::cold, maybe_unused]] static
#define VOXC_INDEX (unsigned long long)
#define VOXC_PRECISE
#if !defined(VOXC_VOLUME) && !defined(VOXC_LOAD)
#define VOXC_OWN_VOLUME
#define VOXC_VOLUME const unsigned int *
#define VOXC_LOAD(volume, index) volume[index]
#endif

#else

#define VOXC_IN(type) const type
#define VOXC_INOUT(type) inout type
#define VOXC_OUT(type) out type
#define VOXC_FUNCTION
#define VOXC_SELDOM
#define VOXC_INDEX uint
#define VOXC_PRECISE precise
#if !defined(VOXC_VOLUME) || !defined(VOXC_LOAD)
#error define VOXC_VOLUME as the type of a volume and VOXC_LOAD(volume, index) as a word of one
#endif

#endif
