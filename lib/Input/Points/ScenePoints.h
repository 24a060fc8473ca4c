// The points of a model that has no lines and no triangles.
#pragma once

#include "Input/Points/PointList.h"
#include "voxc/Mesh/TriangleScene.h"

namespace voxc {

/// True if every primitive of the scene is a point.
bool isOfPoints(const TriangleScene &scene);

/// Copies the points of such a scene, each with its colour. Errors: as `WorkingMemory::allocate`;
/// interrupted.
Expected<std::unique_ptr<PointList>>
pointsOf(const TriangleScene &scene, const std::shared_ptr<WorkingMemory> &memory, const Progress &progress);

} // namespace voxc
