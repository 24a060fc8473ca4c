// Where voxels are: the smallest box around them, and how many there are in each region.
#pragma once

#include "Brick.h"

#include "voxc/Facts/Facts.h"

namespace voxc {

class PlaceTally {
public:
  /// For voxels in the cube of 2^log2Extent cells a side at the origin.
  explicit PlaceTally(int log2Extent);

  /// Takes a brick that is not empty.
  void add(const Brick &brick);

  const RegionFacts &regions() const { return regions_; }
  Int3 boxLow() const { return isEmpty_ ? Int3{} : low_; }
  Int3 boxHigh() const { return isEmpty_ ? Int3{} : high_; }

private:
  void extendBox(const Brick &brick);
  std::uint64_t &regionOf(Int3 cell);

  RegionFacts regions_;
  bool isEmpty_ = true;
  Int3 low_;
  Int3 high_;
};

} // namespace voxc
