// One ray through a volume, on this thread.
#include "Endless.h"
#include "KernelFit.h"

#include "voxc/Trace/CpuKernel.h"

namespace voxc {

Expected<Hit> intersect(const Volume &volume, const CpuKernel &kernel, const Ray &ray) {
  if (auto fits = checkFit(kernel.storageDigest, volume, "cpu"); !fits)
    return fits.error();
  if (kernel.isPaged)
    return Error::usage("this kernel is for volumes in pages: createPagedCpuTracer takes it");
  Hit hit;
  kernel.function(volume.words().data(), ray.origin, reinterpret_cast<std::uint32_t *>(&hit), 1, false, 0);
  if (auto ended = checkEnded({&hit, 1}); !ended)
    return ended.error();
  return hit;
}

} // namespace voxc
