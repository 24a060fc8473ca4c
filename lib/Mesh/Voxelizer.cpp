// Voxelization of a mesh: each triangle's box is halved down to the voxels that it touches.
#include "voxc/Mesh/Voxelizer.h"

#include "Mesh/BoxTriangleTest.h"
#include "Mesh/MeshCheck.h"
#include "Mesh/ModelFrame.h"
#include "Mesh/SurfaceColour.h"
#include "Mesh/Voxelize/NearestPoint.h"
#include "Mesh/Voxelize/VoxelCandidates.h"

#include <algorithm>
#include <cmath>

namespace voxc {

namespace {

/// Triangles between two looks at the progress.
constexpr std::uint32_t kProgressStep = 4096;

Bounds boundsOf(const TriangleMesh &mesh) {
  BoundsBuilder builder;
  for (const Triangle &triangle : mesh.triangles)
    for (std::uint32_t vertex : triangle.vertices)
      builder.add(mesh.positions[vertex]);
  return *builder.bounds();
}

Expected<ModelFrame> frameOf(const TriangleMesh &mesh, const VoxelizeOptions &options) {
  FrameOptions frame{{}, options.resolution, options.maxExtent, options.zUp};
  if (options.bounds) {
    const std::array<double, 6> &b = *options.bounds;
    frame.bounds = {{b[0], b[1], b[2]}, {b[3], b[4], b[5]}};
  } else {
    frame.bounds = boundsOf(mesh);
  }
  return ModelFrame::fit(frame);
}

class Voxelizer {
public:
  Voxelizer(const TriangleMesh &mesh, const ModelFrame &frame) : mesh_(mesh), frame_(frame) {}

  void add(std::uint32_t index) {
    index_ = index;
    for (std::size_t corner = 0; corner < 3; ++corner)
      corners_[corner] = frame_.toVoxels(mesh_.positions[mesh_.triangles[index].vertices[corner]]);
    VoxelBox box = boxOf(corners_);
    for (int axis = 0; axis < 3; ++axis)
      if (box.low[axis] >= box.high[axis])
        return;
    split(BoxTriangleTest(corners_), box);
  }

  std::vector<CodedVoxel> take() { return candidates_.take(); }

private:
  /// The voxels that the triangle's bounding box touches, within the extent. A coordinate on the face between
  /// two voxels touches both, so what lies on the far face of the extent is kept.
  VoxelBox boxOf(const std::array<Double3, 3> &triangle) const {
    VoxelBox box;
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      const auto [low, high] = std::minmax({triangle[0][i], triangle[1][i], triangle[2][i]});
      const double extent = frame_.extent()[axis];
      const double slack = 0x1p-40 * (1 + std::max(std::abs(low), std::abs(high)));
      box.low[axis] = static_cast<int>(std::clamp(std::floor(low - slack), 0.0, extent));
      box.high[axis] = static_cast<int>(std::clamp(std::floor(high + slack) + 1, 0.0, extent));
    }
    return box;
  }

  void split(const BoxTriangleTest &test, const VoxelBox &box) {
    if (!test.touches(box))
      return;
    const Int3 size = box.high - box.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    if (size[axis] == 1)
      return propose(box.low);
    const int middle = box.low[axis] + size[axis] / 2;
    VoxelBox lower = box;
    VoxelBox upper = box;
    lower.high[axis] = upper.low[axis] = middle;
    split(test, lower);
    split(test, upper);
  }

  void propose(Int3 voxel) {
    const NearestPoint nearest = NearestPoints(corners_).to({voxel.x + 0.5, voxel.y + 0.5, voxel.z + 0.5});
    if (const auto word = surfaceColour(mesh_, mesh_.triangles[index_], nearest.weights))
      candidates_.add(mortonCode(voxel), comparedDistance(nearest.distanceSquared), index_, word);
  }

  const TriangleMesh &mesh_;
  const ModelFrame &frame_;
  std::uint32_t index_ = 0;
  std::array<Double3, 3> corners_{};
  VoxelCandidates candidates_;
};

} // namespace

Expected<std::unique_ptr<VoxelSource>> voxelize(const TriangleMesh &mesh, const VoxelizeOptions &options) {
  if (auto checked = checkMesh(mesh); !checked)
    return checked.error();
  const auto frame = frameOf(mesh, options);
  if (!frame)
    return frame.error();
  Voxelizer voxelizer(mesh, *frame);
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  for (std::uint32_t index = 0; index < count; ++index) {
    voxelizer.add(index);
    if (index % kProgressStep != 0)
      continue;
    if (options.progress.stopped())
      return Error::interrupted();
    options.progress.at("voxelize", static_cast<double>(index) / count);
  }
  return makeSortedSource(frame->extent(), voxelizer.take(), frame->voxelToModel());
}

} // namespace voxc
