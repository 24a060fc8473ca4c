// A scene whose triangles are sorted into chunks: what all views of a mesh source share.
#pragma once

#include "Mesh/Voxelize/MeshModel.h"
#include "Mesh/Voxelize/TextureMeans.h"
#include "Mesh/Voxelize/VoxelRule.h"
#include "Source/ChunkBins.h"
#include "voxc/Mesh/MeshSource.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>

namespace voxc {

/// Sizes on which no voxel may depend, tests choose others; and what is known of a scene already.
struct MeshTuning {
  int log2Chunk = 6;                                  ///< Of the cubes whose voxels are made at once; 3 to 6.
  int log2Grid = ChunkBins<std::uint32_t>::kLog2Grid; ///< Of the most bins an axis.
  std::optional<Facing> facing; ///< Of the mesh; default: found where the rule asks for it.
};

/// Once it is open, nothing changes but `nanoseconds`, so that several threads may use it.
struct MeshVoxels {
  std::shared_ptr<const TriangleScene> scene;
  std::shared_ptr<WorkingMemory> memory;
  MeshModel model;
  ChunkBins<std::uint32_t> bins; ///< Triangles by their numbers, which ascend in each bin.
  VoxelRule rule;
  int log2Chunk;
  Progress progress;
  SceneMeans means;                                   ///< None where the nearest texels are wanted.
  mutable std::atomic<std::uint64_t> nanoseconds = 0; ///< Spent on voxels, by all threads.

  static Expected<std::shared_ptr<const MeshVoxels>> open(std::shared_ptr<const TriangleScene> scene,
                                                          const VoxelizeOptions &options,
                                                          const std::shared_ptr<WorkingMemory> &memory,
                                                          const MeshTuning &tuning);
};

/// `makeMeshSource` with other sizes.
Expected<std::unique_ptr<VoxelSource>> makeMeshSource(std::shared_ptr<const TriangleScene> scene,
                                                      const VoxelizeOptions &options,
                                                      const std::shared_ptr<WorkingMemory> &memory,
                                                      const MeshTuning &tuning);

} // namespace voxc
