// What is to be expected of a format for a scene: its words by the scene's graph, its speed by simulated
// rays.
#pragma once

#include "voxc/Search/Candidate.h"
#include "voxc/Search/RayCostModel.h"
#include "voxc/Search/SizeModel.h"
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
struct PredictedFormat {
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
struct ModelledScene {
  const SceneDag &shape;
  const SceneDag *colours = nullptr; ///< Null: formats with colours in place are left out.
  std::uint64_t valueWords = 0;      ///< Of values apart.
  Int3 extent{};                     ///< That a format has to hold.
};

/// Rates formats over one scene. What formats have in common is counted once.
class FormatPredictor {
public:
  explicit FormatPredictor(const ModelledScene &scene);

  /// The candidate with what it takes and costs. None if it cannot hold the scene, takes more than
  /// `maxBytes`, or has colours in place where there is no graph of them.
  std::optional<PredictedFormat> predict(Candidate candidate, std::span<const RaySet> rays,
                                         const SpeedModel &model, std::uint64_t maxBytes);

  /// Simulates other rays, which take the place of those that the format was rated by.
  void simulateAgain(PredictedFormat &format, std::span<const RaySet> rays, const SpeedModel &model) const;

private:
  ModelledScene scene_;
  SizeModel shapes_;
  std::optional<SizeModel> colours_;
};

/// Predicts the times again by another model.
void predictAgain(PredictedFormat &format, const SpeedModel &model);

} // namespace voxc
