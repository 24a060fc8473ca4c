// Boxes of parts, moved to where their instances stand.
#include "Mesh/Voxelize/RegionFilter.h"

#include <algorithm>
#include <optional>

namespace voxc {
namespace {

/// The box of all vertices of a part, used or not.
Bounds boxOf(const MeshPart &part) {
  BoundsBuilder builder;
  for (std::uint64_t vertex = 0; vertex < part.positions.count; ++vertex) {
    const std::array<double, 3> row = readRow<3>(part.positions, vertex);
    builder.add({row[0], row[1], row[2]});
  }
  return builder.bounds().value_or(Bounds{});
}

/// The box of an instance in voxels, a voxel larger than it is for what rounding may add.
Bounds boxInVoxels(const Bounds &part, const Transform &toModel, const ModelFrame &frame) {
  BoundsBuilder builder;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 point = {(corner & 1 ? part.high : part.low).x, (corner & 2 ? part.high : part.low).y,
                              (corner & 4 ? part.high : part.low).z};
    builder.add(frame.toVoxels(toModel * glm::dvec4(point, 1)));
  }
  return {builder.bounds()->low - 1.0, builder.bounds()->high + 1.0};
}

/// True only if they have nothing in common; numbers that are none keep an instance.
bool areApart(const Bounds &box, const std::array<Int3, 2> &region) {
  for (int axis = 0; axis < 3; ++axis)
    if (box.high[axis] < region[0][axis] || box.low[axis] > region[1][axis])
      return true;
  return false;
}

} // namespace

std::vector<std::pair<std::uint64_t, std::uint64_t>>
trianglesNear(std::span<const std::array<Int3, 2>> regions, const TriangleScene &scene,
              const MeshModel &model) {
  if (regions.empty())
    return {{0, model.numbers.size()}};
  std::vector<std::optional<Bounds>> boxes(scene.parts.size());
  std::vector<std::pair<std::uint64_t, std::uint64_t>> runs;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const MeshInstance &instance = scene.instances[i];
    std::optional<Bounds> &box = boxes[instance.part];
    if (!box)
      box = boxOf(scene.parts[instance.part]);
    const Bounds there = boxInVoxels(*box, instance.toModel, model.grid.frame());
    if (!std::ranges::all_of(regions, [&](const auto &region) { return areApart(there, region); }))
      runs.emplace_back(model.numbers.first(i), model.numbers.first(i + 1));
  }
  return runs;
}

} // namespace voxc
