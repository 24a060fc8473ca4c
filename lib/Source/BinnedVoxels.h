// Voxels in any order, sorted into chunks within bounded memory: what points and placed models become.
#pragma once

#include "Source/ChunkBins.h"
#include "voxc/Source/Sources.h"

#include <memory>

namespace voxc {

/// Takes voxels twice, in the same order each time: first `count` for each, then, after `allocate`, `place`.
/// Of several in one place the first wins.
class BinnedVoxels {
public:
  /// Errors: as `WorkingMemory::allocate`.
  static Expected<BinnedVoxels> create(Int3 extent, const std::shared_ptr<WorkingMemory> &memory);

  void count(Int3 voxel) {
    bins_.count(voxel >> bins_.log2Chunk());
    ++counted_;
  }

  /// Errors: as `WorkingMemory::allocate`; 2^32 voxels or more.
  Expected<void> allocate();

  void place(Int3 voxel, std::uint32_t word) {
    bins_.place(voxel >> bins_.log2Chunk(), {mortonCode(voxel), word, placed_++});
    if (placed_ % kVoxelsBetweenReliefs == 0)
      memory_->relieve();
  }

  /// The voxels as a source, once all are placed.
  std::unique_ptr<VoxelSource> finish(const Transform &voxelToModel = {}) &&;

private:
  static constexpr std::uint32_t kVoxelsBetweenReliefs = 1 << 10;

  BinnedVoxels(Int3 extent, ChunkBins<CodedVoxel> bins, std::shared_ptr<WorkingMemory> memory)
      : extent_(extent), bins_(std::move(bins)), memory_(std::move(memory)) {}

  Int3 extent_;
  ChunkBins<CodedVoxel> bins_;
  std::shared_ptr<WorkingMemory> memory_;
  std::uint64_t counted_ = 0;
  std::uint32_t placed_ = 0;
};

} // namespace voxc
