// The verdict of a search, computed in this one place: terminal, page, CSV and JSON all say this.
#pragma once

#include "voxc/Measure/Record.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voxc::measure {

/// A format with its passes, measured on all sets of rays of a search.
struct Finalist {
  std::string name;                  ///< "G(7) M(2^3) with short pointers".
  std::vector<const Record *> cells; ///< One for each set of rays.
  double bytes = 0;
  double mraysPerS = 0;      ///< Of the mean time of all sets, in what the device's clock counts.
  double predictedRatio = 0; ///< The speed that was predicted, divided by the measured one; 0: none was.
  std::string sizeText;      ///< "9.1 KiB", "1.02 MiB".
  std::string speedText;     ///< "12.14 M/s".
  std::string setSpeedsText; ///< "12.10 M/s overview, 3.40 M/s bounced".
};

/// What a reader may ask, and the finalist that answers.
struct SearchAnswer {
  std::string question;     ///< "smallest", "best below 16 KiB", "fastest", "balanced".
  std::size_t finalist = 0; ///< Of the frontier.
  /// Names of others that are no larger than asked for, and that no measured difference distinguishes from
  /// it.
  std::vector<std::string> asFast;
};

struct SearchVerdict {
  std::size_t formats = 0;        ///< That were tried, failures included; other passes make another format.
  std::vector<Finalist> frontier; ///< From small and slow to large and fast; empty if none is fast enough.
  std::vector<SearchAnswer> answers;  ///< From the smallest to the fastest, then balanced; empty likewise.
  std::string objective = "balanced"; ///< The question whose command is printed.
  double fastest = 0; ///< Million rays a second of the fastest that was compared; 0 if there is none.
  std::uint64_t checkedRays = 0, wrongRays = 0;
  std::set<const Record *> cells;    ///< All of the search.
  std::set<const Record *> compared; ///< Those whose times may be compared: only they are on a frontier.

  /// The finalist that answers a question. Precondition: it is asked.
  const Finalist &answer(std::string_view question) const;
  /// How many times the speed of the frontier's formats was predicted too high or too low, at worst; 0 if
  /// nothing was predicted.
  double worstFactor() const;
};

/// The verdict on cells of one model, resolution, device and precision. A format is compared if it was
/// measured on as many sets of rays as there are, and `isCompared` holds for all of its cells; those of less
/// than `leastSpeed` million rays a second answer nothing.
SearchVerdict makeSearchVerdict(const std::vector<const Record *> &cells,
                                const std::function<bool(const Record &)> &isCompared,
                                const std::string &objective, double leastSpeed = 0);

/// What the names of files that hold verdicts begin with.
inline constexpr const char *kVerdictPrefix = "verdict-";

/// Leaves a verdict in a folder for the page of `voxc bench report`: verdict-DIGEST.json, in the place of an
/// earlier one on the same model, resolution, device and precision. Errors: as `writeText`.
Expected<void> writeVerdict(const std::string &folder, const SearchVerdict &verdict);

/// Size as verdicts write it.
std::string verdictSize(double bytes);

/// A format with those of its passes that set it apart from other formats of a search.
std::string plainName(const std::string &format, std::span<const std::string> passes);

} // namespace voxc::measure
