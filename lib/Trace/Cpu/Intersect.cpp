// One ray through a volume, on this thread.
#include "Trace/Kernel/KernelFit.h"
#include "Trace/Kernel/Nontermination.h"

#include "voxc/Trace/CpuKernel.h"

namespace voxc {

namespace {

/// `ray`: as many floats as the kernel takes.
Expected<Hit> intersectOne(const Volume &volume, const CpuKernel &kernel, const float *ray) {
  VOXC_TRY(checkFit(kernel.storageDigest, volume, "cpu"));
  if (kernel.isPaged)
    return Error::usage("this kernel is for volumes in pages: createPagedCpuTracer takes it");
  Hit hit;
  kernel.function(volume.words().data(), ray, reinterpret_cast<std::uint32_t *>(&hit), 1, false, 0);
  VOXC_TRY(checkEnded({&hit, 1}));
  return hit;
}

} // namespace

Expected<Hit> intersect(const Volume &volume, const CpuKernel &kernel, const Ray &ray) {
  return kernel.bounded ? intersect(volume, kernel, bounded(ray)) : intersectOne(volume, kernel, ray.origin);
}

Expected<Hit> intersect(const Volume &volume, const CpuKernel &kernel, const BoundedRay &ray) {
  if (!kernel.bounded)
    return Error::usage(
        "the ray has bounds, but the kernel was compiled for rays without: compile one with bounds=yes");
  return intersectOne(volume, kernel, ray.origin);
}

} // namespace voxc
