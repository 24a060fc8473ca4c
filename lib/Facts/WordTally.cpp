// A hash table of counts, which becomes a plain array of them when it is too large.
#include "WordTally.h"

#include "Mix.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace voxc {

namespace {

constexpr std::size_t kSmallest = 64;

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

WordTally::WordTally(std::size_t most) : most_(most), entries_(kSmallest) {}

bool WordTally::add(std::uint32_t word, std::uint64_t times) {
  if (!exact()) {
    groupOf(word) += times;
    return true;
  }
  Entry &entry = find(word);
  const bool isNew = entry.count == 0;
  entry.word = word;
  entry.count += times;
  used_ += isNew;
  if (used_ > most_)
    joinToGroups();
  else if (2 * used_ > entries_.size())
    grow();
  return isNew;
}

WordTally::Entry &WordTally::find(std::uint32_t word) {
  const std::uint64_t mask = entries_.size() - 1;
  std::uint64_t at = mix(word) & mask;
  while (entries_[at].count != 0 && entries_[at].word != word)
    at = (at + 1) & mask;
  return entries_[at];
}

void WordTally::grow() {
  const std::vector<Entry> old = std::exchange(entries_, std::vector<Entry>(2 * entries_.size()));
  for (const Entry &entry : old)
    if (entry.count != 0)
      find(entry.word) = entry;
}

void WordTally::joinToGroups() {
  const std::vector<Entry> words = std::exchange(entries_, {});
  groups_.resize(std::bit_ceil(most_));
  for (const Entry &entry : words)
    groupOf(entry.word) += entry.count;
}

std::uint64_t &WordTally::groupOf(std::uint32_t word) { return groups_[mix(word) & (groups_.size() - 1)]; }

double WordTally::entropy() const {
  EntropySum sum;
  for (const Entry &entry : entries_)
    sum.add(entry.count);
  for (const std::uint64_t count : groups_)
    sum.add(count);
  return sum.entropy();
}

} // namespace voxc
