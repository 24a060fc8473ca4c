// What generated code for edits talks to: the change, what the volume was, and where words go.
#pragma once

#include "Construct/Host/BuildHost.h"
#include "Construct/Host/VoxelProof.h"
#include "EditStore.h"
#include "OldNodes.h"
#include "VoxelTally.h"

#include "voxc/Source/VoxelChange.h"

#include <cstdint>

namespace voxc {

/// Serves edits of one volume, one after the other.
class EditHost final : public BuildHost {
public:
  /// `extent`: of the volume; beyond it nothing changes. The store and the layout outlive this.
  EditHost(EditStore &store, const Layout &layout, Int3 extent);

  const construct::EditHost &edits() const { return edits_; }

  /// Before an edit: what it is.
  void begin(VoxelChange &change);
  /// After an edit that failed: what its voxels proved is proven no longer.
  void undo() { proof_ = proofOfAll(); }
  /// How many voxels more there are after it.
  std::int64_t moreVoxels() const { return more_; }
  /// The one colour of all voxels, of a payload of one; 0: there is none.
  std::uint32_t colour() const { return proof_.colour(); }

private:
  bool isEmpty(const Cube &) override { return false; }
  void readBrick(Int3, construct::Brick &) override {}

  VoxelProof proofOfAll() const;
  CubeChange changeOf(const Cube &cube);
  std::uint32_t voxel(Int3 at, std::uint32_t old);
  std::uint32_t checked(Int3 at, std::uint32_t word);
  void keepOthers(unsigned level, Ref old);
  void replaced(unsigned level, int layers, const construct::Node &old, int log2Side, std::uint32_t word);
  void fillTable();

  EditStore &words_;
  VoxelFacts facts_;
  OldNodes old_;
  VoxelTally tally_;
  Int3 extent_;
  VoxelProof proof_;
  construct::EditHost edits_{};
  VoxelChange *change_ = nullptr;
  std::int64_t more_ = 0;
};

} // namespace voxc
