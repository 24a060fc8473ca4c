// Situations that are kept, with their counts: a test of speed that needs no clock.
#pragma once

#include "Finding.h"

#include "voxc/Support/Error.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace voxc::cliffs {

/// A line of a file of cases, as `caseLine` writes it.
struct KeptCase {
  std::uint64_t number = 0;
  std::string machine;
  double lookups = 0, exactSteps = 0;
  std::uint64_t allocations = 0;
  std::string what; ///< The place and the situation, by which a number that means another thing now is known.
};

/// The cases of a text; lines that begin with # are comments. Error: a line that is none.
Expected<std::vector<KeptCase>> parseCases(std::string_view text, const std::string &name);

/// What a finding has more of than its case, in words; "" if nothing. Counts may be a fiftieth above.
std::string worsened(const KeptCase &kept, const Finding &finding);

} // namespace voxc::cliffs
