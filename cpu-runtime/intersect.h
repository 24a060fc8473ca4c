/* The kernel in intersect.o: ANSWERS volumes of the format FORMAT. */
#ifndef VOXC_KERNEL_H
#define VOXC_KERNEL_H

#include <stdint.h>

/* The format, and the digest of its storage, which a volume's must equal. */
#define VOXC_KERNEL_FORMAT "FORMAT"
#define VOXC_KERNEL_STORAGE_DIGEST UINT64_C(DIGEST)
/* 1: rays have bounds. */
#define VOXC_KERNEL_BOUNDS HAS_BOUNDS

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Traces `count` rays through the words of a volume. A ray is six floats, origin and direction in voxels;
 * with bounds it is eight: origin, tmin, direction, tmax, and hits are the first voxels that are entered at a
 * t from tmin to tmax. A hit is six words: int32 x, y, z, uint32 rgba, float32 t, uint32 lookups, which are
 * counted if `count_lookups` is not 0; a miss is -1, -1, -1, 0, 0. What the kernel is not asked for is 0 in a
 * hit; a face that it is asked for stands in place of lookups. A kernel of detail=cone stops at what is
 * narrower than `spread` times its distance. The words must be those of a checked volume of this format. Any
 * number of threads may call it.
 */
void voxc_kernel(const uint32_t *words, const float *rays, uint32_t *hits, unsigned long long count,
                 int count_lookups, float spread);

#ifdef __cplusplus
}
#endif

#endif
