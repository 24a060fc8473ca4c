// Collects the voxels that triangles propose and keeps the best proposal for each.
#pragma once

#include "voxc/Source/Sources.h"

#include <cstdint>
#include <vector>

namespace voxc {

/// Proposals for voxels. Memory stays proportional to the number of different voxels.
class VoxelCandidates {
public:
  /// Proposes `word` for the voxel at `code`: the smallest distance wins, then the lowest rank.
  void add(std::uint64_t code, std::uint32_t distance, std::uint32_t rank, std::uint32_t word);

  /// The winners in Morton order; nothing remains.
  std::vector<CodedVoxel> take();

private:
  struct Candidate {
    std::uint64_t code;
    std::uint32_t distance;
    std::uint32_t rank;
    std::uint32_t word;
  };

  static bool before(const Candidate &a, const Candidate &b);
  void compact();

  std::vector<Candidate> candidates_;
  std::size_t sorted_ = 0; ///< The first so many are winners in order.
};

} // namespace voxc
