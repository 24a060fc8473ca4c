// Buffers for the rays of a batch.
#include "RayBuffers.h"

#include "TracePipeline.h"

#include <algorithm>
#include <utility>

namespace voxc {

Expected<RayBuffers> RayBuffers::create(Device::State &device, std::uint64_t rays, bool bounded,
                                        std::uint64_t tileRays) {
  const std::uint64_t bytesOfOne = bounded ? sizeof(BoundedRay) : sizeof(Ray);
  auto raysBuffer = VOXC_TRY(Buffer::create(device, {.what = "the rays", .bytes = rays * bytesOfOne}));
  auto hitsBuffer = VOXC_TRY(Buffer::create(device, {.what = "the hits", .bytes = rays * sizeof(Hit)}));
  auto deferredBuffer = VOXC_TRY(Buffer::create(device, {.what = "the rays that are deferred",
                                                         .bytes = deferredListBytes(std::min(rays, tileRays)),
                                                         .starts = true}));
  return RayBuffers{std::move(raysBuffer), std::move(hitsBuffer), std::move(deferredBuffer)};
}

} // namespace voxc
