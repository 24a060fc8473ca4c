// The hit of a ray on decoded voxels, word by word as docs/ir.md defines it.
#pragma once

#include "VoxelRuns.h"

#include "voxc/Oracle/Oracle.h"
#include "voxc/Trace/BoundedRay.h"

#include <cstddef>

namespace voxc {

/// The first cell of the ray that is not empty and is entered between the bounds; `voxels` is finished. Any
/// six float32 are a ray.
Hit traceExactly(const VoxelRuns &voxels, const Ray &ray, const RayBounds &bounds = {});

/// The voxel in which a ray begins, at t = 0, or a miss; wherever the ray goes.
Hit hitAtOrigin(const VoxelRuns &voxels, const Ray &ray);

/// The hit of `traceExactly` with the face by which the cell is entered, and the first `maxCells` cells up to
/// it, one by one.
Explanation explainExactly(const VoxelRuns &voxels, const Ray &ray, std::size_t maxCells,
                           const RayBounds &bounds = {});

} // namespace voxc
