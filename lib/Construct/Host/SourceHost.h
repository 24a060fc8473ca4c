// A host that serves the voxels of a source.
#pragma once

#include "BuildHost.h"
#include "VoxelProof.h"

#include "voxc/Layout/Layout.h"
#include "voxc/Source/VoxelSource.h"
#include "voxc/Support/Progress.h"

namespace voxc {

/// Tells how far work in Morton order is, and hears whether it shall stop.
class MortonProgress {
public:
  MortonProgress(Int3 extent, const Progress &progress);

  /// Work has come to `low` and found so many voxels. False if it shall stop.
  bool at(Int3 low, std::uint64_t voxels);

private:
  const Progress &progress_;
  std::uint64_t totalCodes_; ///< Of the bounding cube.
  unsigned untilReport_ = 0;
};

/// Reads and counts voxels; also the host of a part, whose result it keeps.
class SourceHost : public BuildHost {
public:
  /// `facts`: what the volume's format states of its voxels. `isEdited`: the source is what edits would make.
  SourceHost(VoxelSource &source, NodeStore &store, VoxelFacts facts, const Progress &progress,
             bool isEdited = false)
      : BuildHost(store), source_(source), proof_(facts, isEdited), progress_(source.extent(), progress) {}

  std::uint64_t voxels() const { return voxels_; }
  /// The one colour of all voxels so far, of a payload of one; 0: none yet.
  std::uint32_t colour() const { return proof_.colour(); }

protected:
  bool isEmpty(const Cube &cube) override { return source_.empty(cube); }
  void readBrick(Int3 low, construct::Brick &brick) override;

private:
  void prove(Int3 low, const std::uint32_t *voxels);

  VoxelSource &source_;
  VoxelProof proof_;
  MortonProgress progress_;
  std::uint64_t voxels_ = 0;
};

} // namespace voxc
