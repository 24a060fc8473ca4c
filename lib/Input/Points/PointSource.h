// Voxels from the points of a PLY file.
#pragma once

#include "Mesh/Ply/PlyReader.h"
#include "voxc/Input/Input.h"
#include "voxc/Source/VoxelSource.h"

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

/// Reads points: integer coordinates are voxel indices, others map like mesh vertices and are floored. The
/// first point of a voxel wins. Errors: as `PlyReader::readRows`, no x, y, z, a coordinate that is not
/// finite, a voxel or more voxels than the format holds.
Expected<PointVoxels> readPoints(PlyReader &reader, const InputOptions &options);

} // namespace voxc
