// Repeated timings of one piece of work: what they say, and whether two of them differ in speed.
#pragma once

#include <vector>

namespace voxc::measure {

/// Seconds of each repeat, in the order in which they ran.
using Repeats = std::vector<double>;

/// The middle of the repeats, or the mean of the two in the middle; 0 without any.
double median(Repeats repeats);

/// From the least to the greatest, as a share of the median; 0 where the median is 0.
double spread(const Repeats &repeats);

/// True if two pieces of work take equally long, as far as these repeats show: their medians differ by no
/// more than the wider of the two spreads.
bool areEqual(const Repeats &a, const Repeats &b);

} // namespace voxc::measure
