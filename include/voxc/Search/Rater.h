// What is to be expected of a format for a scene: its words by the scene's graph, its speed by replayed rays.
#pragma once

#include "voxc/Search/Candidate.h"
#include "voxc/Search/Pricer.h"
#include "voxc/Search/Replay.h"
#include "voxc/Search/SpeedModel.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace voxc {

/// Rays of one kind, and what they count.
struct RaySet {
  std::string name; ///< Such as "camera".
  std::vector<Ray> rays;
  bool isBinned =
      false; ///< A tracer sorts them first (`RayOrder::Binned`), so that they stand here in that order.
};

/// One candidate, and what is to be expected of it.
struct RatedFormat {
  Candidate candidate;
  Price price;
  std::vector<RayCost> costs;      ///< Of each set of rays.
  std::vector<double> nanoseconds; ///< A ray of each set takes so many, as the model has it.
  double factor = 1;               ///< How many times as long a ray takes as the model's counts say.

  std::uint64_t bytes() const { return 4 * price.words(); }
  /// The mean of all sets.
  double time() const;
};

/// What candidates are priced on.
struct PricedScene {
  const SceneDag &shape;
  const SceneDag *colours = nullptr; ///< Null: formats with colours in place are left out.
  std::uint64_t valueWords = 0;      ///< Of values apart.
};

/// Rates formats over one scene. What formats have in common is counted once.
class Rater {
public:
  explicit Rater(const PricedScene &scene);

  /// The candidate with what it takes and costs. None if it cannot hold the scene, takes more than
  /// `maxBytes`, or has colours in place where there is no graph of them.
  std::optional<RatedFormat> rate(Candidate candidate, std::span<const RaySet> rays, const SpeedModel &model,
                                  std::uint64_t maxBytes);

  /// Replays other rays, which take the place of those that the format was rated by.
  void replayAgain(RatedFormat &format, std::span<const RaySet> rays, const SpeedModel &model) const;

private:
  PricedScene scene_;
  Pricer shapes_;
  std::optional<Pricer> colours_;
};

/// Tells the times anew by another model.
void predictAgain(RatedFormat &format, const SpeedModel &model);

} // namespace voxc
