// A hash set of hashes that thins itself out.
#include "DistinctSet.h"

#include "Mix.h"

#include <utility>

namespace voxc {

namespace {

constexpr int kLog2Smallest = 6;

} // namespace

DistinctSet::DistinctSet(std::size_t most) : most_(most) { rebuild(kLog2Smallest); }

void DistinctSet::insert(std::uint64_t value) {
  const std::uint64_t hash = mix(value);
  if (!isSampled(hash))
    return;
  place(hash);
  while (used_ > most_) {
    ++level_;
    rebuild(log2Slots_);
  }
  if (2 * used_ > slots_.size())
    rebuild(log2Slots_ + 1);
}

void DistinctSet::place(std::uint64_t hash) {
  const std::uint64_t mask = slots_.size() - 1;
  // The low bits are those that the sample is taken by.
  std::uint64_t at = hash >> (64 - log2Slots_);
  while (slots_[at] != 0 && slots_[at] != hash)
    at = (at + 1) & mask;
  used_ += slots_[at] == 0;
  slots_[at] = hash;
}

void DistinctSet::rebuild(int log2Slots) {
  const std::vector<std::uint64_t> old = std::exchange(slots_, {});
  log2Slots_ = log2Slots;
  slots_.resize(std::size_t{1} << log2Slots);
  used_ = 0;
  for (const std::uint64_t hash : old)
    if (hash != 0 && isSampled(hash))
      place(hash);
}

} // namespace voxc
