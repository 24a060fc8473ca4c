// The formats that are best for a scene, these rays and this device, found by measuring those that promise
// most.
#pragma once

#include "voxc/Measure/SearchLoop.h"
#include "voxc/Measure/SearchVerdict.h"
#include "voxc/Search/Explore.h"
#include "voxc/Search/SearchScene.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace voxc::measure {

struct FormatSearchOptions {
  Wish wish;
  double leastSpeed = 0;     ///< Million rays a second; slower formats are of no use.
  bool onlySeeds = false;    ///< Formats that it begins with, and no others: nothing is left out.
  std::size_t maxLevels = 0; ///< Of a format; 0: as `explore` says, and any number of the seeds.
  bool measuresAll = false;  ///< However little a format promises.
  bool measuresAgain = true; ///< What is best, in turn, at the end: so that its times can be compared.
  ExploreOptions explore;    ///< Its `seconds` are those of the budget.
  MeasurementOptions measurement;
};

class FormatSearch {
public:
  /// There is one set of rays at least. The scene must outlive the search.
  FormatSearch(const SearchScene &scene, std::vector<MeasuredSet> sets, FormatSearchOptions options);

  /// Rates the seeds, and what rewriting makes of those near the frontier. What the budget ends is left out.
  Explored explore(std::vector<Candidate> seeds, const TimeBudget &budget, const Progress &progress) const;

  /// Measures once formats of those that were rated, of which there is one at least, after what is `known` of
  /// an earlier search. Errors: `Interrupted`, by the budget while exact hits are found, or by the caller,
  /// with which everything that was found is there; those of `keep`.
  Expected<void> measure(Explored explored, const std::vector<Record> &known, const KeepRecord &keep,
                         const TimeBudget &budget, const Progress &progress);

  /// After `measure`; null while there is none.
  const Acquisition *acquisition() const { return acquisition_.get(); }
  const SearchLoop *loop() const { return loop_.get(); }

  /// The verdict on the records of what was measured, which must outlive it. Precondition: there is a loop.
  SearchVerdict verdict(const std::vector<Record> &records) const;

private:
  const SearchScene *scene_;
  std::vector<MeasuredSet> sets_; ///< Until they are measured by.
  FormatSearchOptions options_;
  SpeedModel model_;
  std::vector<RaySet> simulated_;
  std::unique_ptr<Acquisition> acquisition_;
  std::optional<MeasurementSession> session_;
  std::unique_ptr<SearchLoop> loop_;
};

/// Rays from where those of an eye hit the scene, that go anywhere; none if all miss. The same for a seed.
std::optional<MeasuredSet> bouncedSet(const SearchScene &scene, const std::vector<Ray> &eye,
                                      std::uint32_t seed, RayOrder order = RayOrder::Auto);

} // namespace voxc::measure
