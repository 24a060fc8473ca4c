// Voxels from the points of a PLY file.
#pragma once

#include "Input/Points/PointList.h"
#include "Mesh/Ply/PlyReader.h"
#include "voxc/Input/Input.h"
#include "voxc/Source/VoxelSource.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace voxc {

struct PointVoxels {
  std::unique_ptr<VoxelSource> source;
  bool areIndices = false; ///< The points have integer coordinates, which are voxel indices.
  std::vector<std::string> warnings;
  std::vector<InputFact> facts; ///< If they were asked for.
};

/// Points as voxels: where the coordinates are indices, they are those of voxels; others map like mesh
/// vertices and are floored. The first point of a voxel wins. `broken` makes an error about the file of what
/// is wrong with it. Errors: a coordinate that is not finite, a voxel or more voxels than the format holds.
Expected<PointVoxels> placePoints(const PointList &points, bool areIndices, const InputOptions &options,
                                  const std::function<Error(const std::string &)> &broken);

/// Reads points of a PLY file: integer coordinates are indices. Errors: those of `placePoints` and of
/// `PlyReader::readRows`; no x, y, z.
Expected<PointVoxels> readPoints(PlyReader &reader, const InputOptions &options);

} // namespace voxc
