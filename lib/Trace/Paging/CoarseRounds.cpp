// Waiting rays and coarse blocks.
#include "CoarseRounds.h"

#include "Support/ParallelFor.h"

#include <algorithm>
#include <atomic>

namespace voxc {
namespace {

constexpr std::uint64_t kChunkRays = 2048;

} // namespace

CoarseStandIn::Outcome CoarseRounds::answerRay(std::uint64_t i) {
  using enum CoarseStandIn::Outcome;
  Hit &hit = hits_[i];
  if (hit.voxel[0] >= -1)
    return Waits; // It has a hit already, and waits for nothing.
  const Int3 cell = {-2 - hit.voxel[0], -2 - hit.voxel[1], -2 - hit.voxel[2]};
  const Ray ray = rays_[i];
  const double entry = CoarseStandIn::entryOf(ray, cell);
  if (entry < until_[i])
    return Waits;
  const CoarseStandIn::Answer answer = standIn_.answer(ray, entry, view_);
  if (answer.outcome == Waits) {
    until_[i] = answer.until;
    return Waits;
  }
  const std::uint32_t steps = hit.steps; // As many as it took until here.
  hit = answer.hit;
  hit.steps = steps;
  return answer.outcome;
}

std::uint64_t CoarseRounds::answer(std::uint64_t first, std::uint64_t count) {
  std::atomic<std::uint64_t> missed = 0, answered = 0;
  parallelFor((count + kChunkRays - 1) / kChunkRays, threads_, [&](std::uint64_t chunk) {
    const std::uint64_t begin = first + chunk * kChunkRays;
    const std::uint64_t end = std::min(begin + kChunkRays, first + count);
    std::uint64_t misses = 0, answers = 0;
    for (std::uint64_t i = begin; i < end; ++i) {
      const CoarseStandIn::Outcome outcome = answerRay(i);
      misses += outcome == CoarseStandIn::Outcome::Misses;
      answers += outcome == CoarseStandIn::Outcome::Answered;
    }
    missed += misses;
    answered += answers;
  });
  answered_ += answered;
  return missed + answered;
}

} // namespace voxc
