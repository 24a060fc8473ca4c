// The hit of a ray on decoded voxels, word by word as the contract defines it.
#pragma once

#include "VoxelRuns.h"

#include "voxc/Trace/Ray.h"

namespace voxc {

/// The first cell of the ray that is not empty; `voxels` is finished. Any six float32 are a ray.
Hit traceExactly(const VoxelRuns &voxels, const Ray &ray);

} // namespace voxc
