// The verdict: what each question of a reader has for an answer on one model.
#pragma once

#include "report/Catalogue.h"

#include <string>
#include <vector>

namespace voxc::report {

/// The answer of one stage.
struct Answer {
  const Stage *stage = nullptr;
  const Entry *entry = nullptr;
  std::vector<const Entry *>
      asFast; ///< Others that answer as well, the fastest first: no speed tells them apart.
};

struct Question {
  std::string text; ///< "Smallest", "Fastest", "Best below 16 MiB".
  std::vector<Answer> answers;
};

/// The questions that these stages, of one model at one resolution with the same rays, answer differently:
/// the smallest, the fastest, and the fastest of at most 2^n bytes for up to three n. None without points.
std::vector<Question> verdict(const Catalogue &catalogue, const std::vector<const Stage *> &stages);

} // namespace voxc::report
