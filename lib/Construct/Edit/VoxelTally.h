// How many voxels a node or a sub-volume has: each that is shared is counted once.
#pragma once

#include "OldNodes.h"

#include <cstdint>
#include <unordered_map>

namespace voxc {

class VoxelTally {
public:
  explicit VoxelTally(const OldNodes &nodes) : nodes_(nodes) {}

  /// 0 of a reference that is 0.
  std::uint64_t ofSubVolume(unsigned level, Ref ref);
  /// Of a node so many layers above the cells of its level.
  std::uint64_t ofNode(unsigned level, int layers, const construct::Node &node);

  /// Grids may change where they are: what was counted holds no longer.
  void forget() { known_.clear(); }

private:
  std::uint64_t ofCell(unsigned level, std::uint32_t value);
  std::uint64_t ofGrid(unsigned level, Ref ref);

  const OldNodes &nodes_;
  std::unordered_map<std::uint64_t, std::uint64_t> known_;
};

} // namespace voxc
