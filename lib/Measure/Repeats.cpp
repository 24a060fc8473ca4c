// What repeated timings say.
#include "voxc/Measure/Repeats.h"

#include <algorithm>
#include <cmath>

namespace voxc::measure {

double median(Repeats repeats) {
  if (repeats.empty())
    return 0;
  std::ranges::sort(repeats);
  const std::size_t half = repeats.size() / 2;
  return repeats.size() % 2 ? repeats[half] : (repeats[half - 1] + repeats[half]) / 2;
}

double spread(const Repeats &repeats) {
  const double middle = median(repeats);
  return middle > 0 ? (std::ranges::max(repeats) - std::ranges::min(repeats)) / middle : 0;
}

bool areEqual(const Repeats &a, const Repeats &b) {
  const double first = median(a), second = median(b);
  return std::abs(first - second) <= std::max(first * spread(a), second * spread(b));
}

} // namespace voxc::measure
