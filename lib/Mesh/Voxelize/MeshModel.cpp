// Fitting a scene into voxels.
#include "Mesh/Voxelize/MeshModel.h"

#include "Mesh/Voxelize/SceneBounds.h"

#include <utility>

namespace voxc {

Expected<MeshModel> MeshModel::open(const TriangleScene &scene, const VoxelizeOptions &options,
                                    WorkingMemory *memory) {
  VOXC_TRY(checkReferences(scene));
  TriangleNumbers numbers(scene);
  const auto model = VOXC_TRY(boundsOf(scene, numbers, memory, options.progress));
  FrameOptions place{model, options.resolution, options.maxExtent, options.zUp};
  if (options.bounds) {
    const std::array<double, 6> &b = *options.bounds;
    place.bounds = {{b[0], b[1], b[2]}, {b[3], b[4], b[5]}};
  }
  place.voxelSize = options.voxelSize;
  if (options.align)
    place.align = glm::dvec3((*options.align)[0], (*options.align)[1], (*options.align)[2]);
  const auto frame = VOXC_TRY(ModelFrame::fit(place));
  const auto grid = VOXC_TRY(SnapGrid::fit(frame, model));
  return MeshModel{std::move(numbers), grid};
}

SnappedTriangle MeshModel::snapped(const std::array<glm::dvec3, 3> &corners) const {
  return {{grid.snap(corners[0]), grid.snap(corners[1]), grid.snap(corners[2])}};
}

std::array<glm::dvec3, 3> MeshModel::inVoxels(const SnappedTriangle &triangle) const {
  const double step = 1.0 / static_cast<double>(std::int64_t{1} << grid.bits());
  std::array<glm::dvec3, 3> corners;
  for (std::size_t corner = 0; corner < 3; ++corner)
    for (int axis = 0; axis < 3; ++axis)
      corners[corner][axis] =
          static_cast<double>(triangle.corners[corner][static_cast<std::size_t>(axis)]) * step;
  return corners;
}

} // namespace voxc
