// What follows from facts for the choice of a format, in plain sentences.
#pragma once

#include "voxc/Facts/Facts.h"

#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// One sentence, and the name of the rule that it follows.
struct Recommendation {
  std::string_view rule; ///< "voxels", "alpha", "colours" and so on: docs/facts.md has them all.
  std::string text;
};

/// The sentences of all rules that have something to say, one a rule. docs/facts.md states the rules.
std::vector<Recommendation> recommend(const Facts &facts);

} // namespace voxc
