// Buffers for the rays of a batch.
#include "RayBuffers.h"

#include "TracePipeline.h"

#include <algorithm>
#include <utility>

namespace voxc {

Expected<RayBuffers> RayBuffers::create(Device::State &device, std::uint64_t rays, bool bounded,
                                        std::uint64_t tileRays) {
  const std::uint64_t bytesOfOne = bounded ? sizeof(BoundedRay) : sizeof(Ray);
  auto raysBuffer = Buffer::create(device, {.what = "the rays", .bytes = rays * bytesOfOne});
  if (!raysBuffer)
    return raysBuffer.error();
  auto hitsBuffer = Buffer::create(device, {.what = "the hits", .bytes = rays * sizeof(Hit)});
  if (!hitsBuffer)
    return hitsBuffer.error();
  auto deferredBuffer = Buffer::create(device, {.what = "the rays that are deferred",
                                                .bytes = deferredListBytes(std::min(rays, tileRays)),
                                                .starts = true});
  if (!deferredBuffer)
    return deferredBuffer.error();
  return RayBuffers{std::move(*raysBuffer), std::move(*hitsBuffer), std::move(*deferredBuffer)};
}

} // namespace voxc
