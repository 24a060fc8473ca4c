// Between two rounds of rays: those that wait for pages for which coarse blocks may stand in get their hits.
#pragma once

#include "CoarseStandIn.h"

#include "voxc/Trace/BoundedRay.h"

#include <cstdint>
#include <span>
#include <vector>

namespace voxc {

/// The rays of one batch, from their beginning to their end.
class CoarseRounds {
public:
  CoarseRounds(const CoarseStandIn &standIn, RaySpan rays, std::span<Hit> hits, const CoarseView &view,
               unsigned threads)
      : standIn_(standIn), rays_(rays), hits_(hits), view_(view), threads_(threads), until_(rays.size()) {}

  /// Looks after `count` rays from `first` on. How many have found their end, by blocks or by certain misses.
  std::uint64_t answer(std::uint64_t first, std::uint64_t count);
  /// How many rays blocks have answered so far.
  std::uint64_t answered() const { return answered_; }

private:
  CoarseStandIn::Outcome answerRay(std::uint64_t i);

  const CoarseStandIn &standIn_;
  RaySpan rays_;
  std::span<Hit> hits_;
  CoarseView view_;
  unsigned threads_;
  std::vector<float> until_; ///< Of each ray that found a box which looks large: where it has left that.
  std::uint64_t answered_ = 0;
};

} // namespace voxc
