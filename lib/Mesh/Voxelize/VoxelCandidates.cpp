// Sorting of proposals, whenever as many have come as there were winners.
#include "Mesh/Voxelize/VoxelCandidates.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace voxc {

namespace {

/// Fewer proposals are not worth sorting.
constexpr std::size_t kSmallest = std::size_t{1} << 20;

} // namespace

bool VoxelCandidates::before(const Candidate &a, const Candidate &b) {
  return std::tie(a.code, a.distance, a.rank) < std::tie(b.code, b.distance, b.rank);
}

void VoxelCandidates::add(std::uint64_t code, std::uint32_t distance, std::uint32_t rank,
                          std::uint32_t word) {
  if (candidates_.size() >= std::max(kSmallest, 2 * sorted_))
    compact();
  candidates_.push_back({code, distance, rank, word});
}

void VoxelCandidates::compact() {
  std::sort(candidates_.begin(), candidates_.end(), before);
  const auto end = std::unique(candidates_.begin(), candidates_.end(),
                               [](const Candidate &a, const Candidate &b) { return a.code == b.code; });
  candidates_.erase(end, candidates_.end());
  sorted_ = candidates_.size();
}

std::vector<CodedVoxel> VoxelCandidates::take() {
  compact();
  std::vector<CodedVoxel> voxels;
  voxels.reserve(candidates_.size());
  for (const Candidate &candidate : candidates_)
    voxels.push_back({candidate.code, candidate.word});
  candidates_ = {};
  sorted_ = 0;
  return voxels;
}

} // namespace voxc
