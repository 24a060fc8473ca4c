// A CUDA kernel around the functions of a header (voxc compile --emit=header --language cuda --name scene): one thread a ray. Compiled to PTX
// by Clang, which needs no toolkit for that, or by nvcc.
#ifdef __clang__
#define __global__ __attribute__((global))
#endif
#ifndef BLOCKS // Of 64 threads, at least so many on a multiprocessor: a bound on registers.
#define BLOCKS 1
#endif
#ifdef __clang__
#define BOUNDS __attribute__((launch_bounds(64, BLOCKS)))
#else
#define BOUNDS __launch_bounds__(64, BLOCKS)
#endif
#include "voxc_scene.cuh"

struct Hit { // As hits lie in the buffers of all kernels (voxc/Trace/Ray.h).
  int voxel[3];
  unsigned colour;
  float t;
  unsigned steps;
};

extern "C" __global__ void BOUNDS trace(const unsigned *words, const float *rays, Hit *hits, unsigned count) {
#ifdef __clang__
  const unsigned i =
      __nvvm_read_ptx_sreg_ctaid_x() * __nvvm_read_ptx_sreg_ntid_x() + __nvvm_read_ptx_sreg_tid_x();
#else
  const unsigned i = blockIdx.x * blockDim.x + threadIdx.x;
#endif
  if (i >= count)
    return;
  const float *ray = rays + 6ull * i;
  voxc_scene_Hit hit;
  const bool found = voxc_scene_closest(words, {ray[0], ray[1], ray[2]}, {ray[3], ray[4], ray[5]}, 0.0f,
                                        3.402823466e+38f, hit);
  hits[i] = found ? Hit{{hit.voxel.x, hit.voxel.y, hit.voxel.z}, hit.colour, hit.t, 0u}
                  : Hit{{-1, -1, -1}, 0u, 0.0f, 0u};
}
