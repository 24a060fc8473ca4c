// What the command line says to voxc search.
#pragma once

#include "common/Command.h"
#include "options/BuildArguments.h"
#include "options/InputArguments.h"
#include "sweep/RaySet.h"
#include "sweep/ShareOptions.h"
#include "voxc/Search/Explore.h"
#include "voxc/Search/Suggest.h"

#include <cstdint>
#include <string>

namespace voxc::tool {

struct SearchOptions {
  std::string input, folder;
  InputArguments inputArguments; ///< After `read` with a resolution.
  double budget = 0;             ///< In seconds; set by `read`.
  Wish wish;                     ///< Set by `read`.
  double leastSpeed = 0;         ///< Million rays a second.
  std::string device, precision = "exact";
  bench::RayArguments rays;
  std::string formatList; ///< "": all of the space.
  ExploreOptions explore;
  std::size_t maxLevels = 0; ///< 0: `explore.maxLevels`, but any number of those that it begins with.
  std::size_t check = 2000;
  bool all = false;           ///< Measure whatever is looked at.
  bench::ShareOptions shares; ///< Only of the formats of a list, all of which are measured.
  std::uint32_t seed = 1;
  BuildArguments building;
  CommonOptions common;

  void declare(const CommandLine &command);
  /// Reads what is written in words. Error: `Usage`.
  Expected<void> read();
  /// "balanced", "fastest" or "smallest".
  const std::string &objective() const { return objective_; }
  /// What was typed, as far as it matters to who reads the records.
  std::string commandText() const;

private:
  std::string budgetText_ = "180s", objective_ = "balanced";
};

} // namespace voxc::tool
