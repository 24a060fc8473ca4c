/* voxc_format_*: rays through volumes of the format FORMAT, as functions for C.
 *
 * voxc_format_c.cpp defines them: compile that as C++20, by any compiler of GCC's kind, with voxc_format.h
 * beside it. It needs no library of C++, so that the program is linked as one of C. In C++ include
 * voxc_format.h itself.
 *
 * A volume is its words, of a checked volume of this very format. Rays are in voxels; a direction may have
 * any length, and t counts in it. Nothing here keeps a state: any number of threads may call. */
#ifndef VOXC_FORMAT_C_H
#define VOXC_FORMAT_C_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The format, and the digest of its storage. The words of a volume are for these functions if
 * voxc_volume_digest() of it, or the digest that `voxc info` prints, equals this one, and else lead anywhere.
 */
#define VOXC_FORMAT_FORMAT "FORMAT"
#define VOXC_FORMAT_STORAGE_DIGEST DIGESTull

/* A voxel on a ray. A miss is -1, -1, -1, 0, 0, -1, 0. */
typedef struct voxc_format_Hit {
  int32_t voxel[3];
  float t;         /* When the ray enters it, rounded to nearest; 0 where the ray begins in it. */
  uint32_t colour; /* Its word: COLOUR_MEANING. */
  int32_t axis;    /* Of the face by which the ray enters, 0, 1, 2 for x, y, z; the first of several. -1: it
                      begins inside. */
  int32_t
      side; /* -1 where that is the voxel's low face, 1 where it is the high one; 0 where there is none. */
} voxc_format_Hit;

/* The first voxel that the ray enters at a t in [tmin, tmax], in exact arithmetic; a NaN is in no interval.
 * The voxel in which the ray begins is entered at t = 0. */
bool voxc_format_closest(const uint32_t *words, const float origin[3], const float direction[3], float tmin,
                         float tmax, voxc_format_Hit *hit);

/* From a hit of this very ray to the next voxel on it, if that is entered at tmax or before. None is left out
 * or comes twice. */
bool voxc_format_next(const uint32_t *words, const float origin[3], const float direction[3], float tmax,
                      voxc_format_Hit *hit);

/* Whether there is a voxel that the ray enters at a t in [tmin, tmax]. */
bool voxc_format_any(const uint32_t *words, const float origin[3], const float direction[3], float tmin,
                     float tmax);

/* The normal of the face by which the ray enters, out of the voxel; 0 where there is none. */
void voxc_format_normal(const voxc_format_Hit *hit, float normal[3]);

/* Where the ray of a hit enters the voxel, just outside of it: from there rays go on without a tmin. */
void voxc_format_outside(const float origin[3], const float direction[3], const voxc_format_Hit *hit,
                         float place[3]);

#ifdef __cplusplus
}
#endif

#endif
