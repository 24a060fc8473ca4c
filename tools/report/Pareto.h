// The Pareto frontier: formats that no other beats in both size and speed, and what the rounds can tell of
// it.
#pragma once

#include "bench/Record.h"

#include <cstddef>
#include <span>
#include <vector>

namespace voxc::report {

struct SizeSpeed {
  double size = 0;
  double speed = 0;
};

/// For each point whether it lies on the frontier: no other is at least as small and at least as fast, and
/// better in one of the two. Equal points are all on it, or none.
std::vector<bool> paretoFrontier(std::span<const SizeSpeed> points);

/// A size to the byte, and a speed with its rounds.
struct MeasuredPoint {
  double bytes = 0;
  tool::bench::Speed speed;
};

/// How a point stands to the frontier.
enum class Place {
  Leading, ///< On it: measurably faster than all that are at least as small.
  AsGood,  ///< No measured difference from one that leads: as fast, and hardly larger.
  Beaten,  ///< One that leads is smaller and at least as fast, or as small and faster.
};

struct Standing {
  Place place = Place::Beaten;
  std::size_t rival = 0; ///< The fastest leader that is at least as small; of a leader itself.
};

/// A size that is larger by no more than this share is hardly larger.
inline constexpr double kHardlyLarger = 0.01;

/// The standing of each point. Of the frontier of the medians those lead that differ from the leader before
/// them, the next smaller one, by more than their rounds do (`areEqual`): the smallest always leads.
std::vector<Standing> standings(std::span<const MeasuredPoint> points);

} // namespace voxc::report
