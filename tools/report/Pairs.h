// Pairs of cells that differ in one thing alone: a pass, or the precision.
#pragma once

#include "report/Catalogue.h"

#include <string>
#include <string_view>
#include <vector>

namespace voxc::report {

struct Pair {
  const Entry *with = nullptr;
  const Entry *without = nullptr;
};

/// Measured cells with a pass, each beside the one without it that is the same in all else.
std::vector<Pair> pairsByPass(const Catalogue &catalogue, std::string_view pass);

/// Measured cells of precision `fast`, each beside the `exact` one that is the same in all else.
std::vector<Pair> pairsByPrecision(const Catalogue &catalogue);

/// How many times as small the volume is with it; 0 if a size is not known.
double shrinkage(const Pair &pair);
/// How many times as fast it is with it; 0 if a speed is not known.
double speedUp(const Pair &pair);
/// Whether both speeds are known and differ by no more than the wider of their spreads.
bool isAsFast(const Pair &pair);

} // namespace voxc::report
