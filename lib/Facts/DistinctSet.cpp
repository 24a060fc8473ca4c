// A hash set of hashes that thins itself out.
#include "DistinctSet.h"

#include "Mix.h"

namespace voxc {

void DistinctSet::insert(std::uint64_t value) {
  const std::uint64_t hash = mix(value);
  if (!isSampled(hash))
    return;
  hashes_[hash];
  while (hashes_.size() > most_) {
    ++level_;
    hashes_.keepIf([this](std::uint64_t kept) { return isSampled(kept); });
  }
}

} // namespace voxc
