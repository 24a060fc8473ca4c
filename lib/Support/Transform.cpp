// Entries of affine maps.
#include "voxc/Support/Transform.h"

#include <algorithm>
#include <cmath>

namespace voxc {

std::array<double, 12> rowsOf(const Transform &transform) {
  std::array<double, 12> rows{};
  for (int i = 0; i < 12; ++i)
    rows[static_cast<std::size_t>(i)] = transform[i % 4][i / 4];
  return rows;
}

Transform transformOfRows(const std::array<double, 12> &rows) {
  Transform transform;
  for (int i = 0; i < 12; ++i)
    transform[i % 4][i / 4] = rows[static_cast<std::size_t>(i)];
  return transform;
}

bool isFinite(const Transform &transform) {
  return std::ranges::all_of(rowsOf(transform), [](double entry) { return std::isfinite(entry); });
}

} // namespace voxc
