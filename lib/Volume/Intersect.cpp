// One ray through a volume, on this thread.
#include "voxc/Volume/Volume.h"

#include "Trace/Endless.h"
#include "Trace/KernelFit.h"
#include "voxc/Trace/CpuKernel.h"

namespace voxc {

Expected<Hit> Volume::intersect(const CpuKernel &kernel, const Ray &ray) const {
  if (auto fits = checkFit(kernel.storageDigest, *this, "cpu"); !fits)
    return fits.error();
  Hit hit;
  kernel.function(words().data(), ray.origin, reinterpret_cast<std::uint32_t *>(&hit), 1, false, 0);
  if (auto ended = checkEnded({&hit, 1}); !ended)
    return ended.error();
  return hit;
}

} // namespace voxc
