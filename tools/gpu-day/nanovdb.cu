// NanoVDB's own traversal (`nanovdb::firstActive`) as a CUDA kernel: what voxc is measured beside, on the same voxels and rays.
//   nvcc -ptx --expt-relaxed-constexpr nanovdb.cu
#include <nanovdb/NanoVDB.h>
#include <nanovdb/util/HDDA.h>
#include <nanovdb/util/Ray.h>

struct Hit { // As hits lie in the buffers of all kernels (voxc/Trace/Ray.h).
  int voxel[3];
  unsigned colour;
  float t;
  unsigned steps;
};

extern "C" __global__ void trace(const unsigned *grid, const float *rays, Hit *hits, unsigned count) {
  const unsigned i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i >= count)
    return;
  const auto &tree = reinterpret_cast<const nanovdb::NanoGrid<nanovdb::Rgba8> *>(grid)->tree();
  const auto accessor = tree.getAccessor();
  const float *given = rays + 6ull * i;
  const nanovdb::Vec3f origin(given[0], given[1], given[2]);
  nanovdb::Vec3f direction(given[3], given[4], given[5]);
  const float length = direction.length(); // It steps by a voxel along directions of length 1.
  nanovdb::Ray<float> ray(origin, direction / length);
  nanovdb::Coord voxel;
  float t;
  Hit hit{{-1, -1, -1}, 0u, 0.0f, 0u};
  if (nanovdb::firstActive(ray, accessor, voxel, t))
    hit = {{voxel.x(), voxel.y(), voxel.z()}, accessor.getValue(voxel).packed(), t / length, 0u};
  hits[i] = hit;
}
