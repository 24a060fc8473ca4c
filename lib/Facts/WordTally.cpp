// A hash table of counts, which becomes a plain array of them when it is too large.
#include "WordTally.h"

#include "Mix.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace voxc {

namespace {

/// Sums n and n log2 n over counts: log2 of all minus their mean log2 is the entropy.
struct EntropySum {
  double all = 0;
  double weighted = 0;

  void add(std::uint64_t count) {
    const auto n = static_cast<double>(count);
    all += n;
    weighted += count > 0 ? n * std::log2(n) : 0;
  }
  /// Rounding alone could make it less than 0.
  double entropy() const { return all > 0 ? std::max(0.0, std::log2(all) - weighted / all) : 0; }
};

} // namespace

bool WordTally::add(std::uint32_t word, std::uint64_t times) {
  if (!exact()) {
    groupOf(word) += times;
    return true;
  }
  std::uint64_t &count = counts_[word];
  const bool isNew = count == 0;
  count += times;
  if (counts_.size() > most_)
    joinToGroups();
  return isNew;
}

void WordTally::joinToGroups() {
  groups_.resize(std::bit_ceil(most_));
  counts_.forEach([this](std::uint32_t word, std::uint64_t count) { groupOf(word) += count; });
  counts_ = {};
}

std::uint64_t &WordTally::groupOf(std::uint32_t word) { return groups_[mix(word) & (groups_.size() - 1)]; }

double WordTally::entropy() const {
  EntropySum sum;
  counts_.forEach([&sum](std::uint32_t, std::uint64_t count) { sum.add(count); });
  for (const std::uint64_t count : groups_)
    sum.add(count);
  return sum.entropy();
}

} // namespace voxc
