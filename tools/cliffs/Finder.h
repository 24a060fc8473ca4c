// Goes through situations and finds what they cost.
#pragma once

#include "Finding.h"
#include "Peer.h"

#include <functional>
#include <optional>
#include <vector>

namespace voxc::cliffs {

struct FinderOptions {
  std::uint64_t seed = 1;
  DrawLimits limits;
  bool countsAlone = false; ///< Nothing is timed: what is found is the same on every machine.
};

class Finder {
public:
  /// Calibrates the speed model on each machine, unless counts alone are asked for.
  static Expected<Finder> create(std::vector<Machine> machines, const FinderOptions &options,
                                 std::optional<Peer> peer);

  /// Goes through a situation on all machines; those that cannot be have no finding. Errors: of what traces.
  Expected<std::vector<Finding>> find(std::uint64_t number);

  const std::vector<Calibration> &calibrations() const { return calibrations_; }

private:
  Finder(std::vector<Machine> machines, const FinderOptions &options, std::optional<Peer> peer);
  Expected<void> calibrate();
  Expected<void> enter(const Place &place);
  Expected<std::optional<Finding>> findOn(std::size_t machine, const Situation &situation,
                                          const StagedRays &rays, const Calibration &calibration);
  Expected<Cost> costMovedOff(KernelShelf &shelf, const Situation &situation, const StagedRays &rays) const;
  Expected<void> count(KernelShelf &shelf, const Situation &situation, const StagedRays &some,
                       Subject &subject, Finding &finding) const;

  std::vector<Machine> machines_;
  FinderOptions options_;
  std::optional<Peer> peer_;
  std::vector<KernelShelf> shelves_;
  std::vector<Calibration> calibrations_;
  std::optional<Stage> stage_;
  std::optional<std::uint64_t> place_; ///< Whose stage that is; it may have none.
};

} // namespace voxc::cliffs
