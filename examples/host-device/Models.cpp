// The two models.
#include "Models.h"

#include <cmath>

std::uint32_t spongeVoxel(voxc::Int3 cell) {
  for (int x = cell.x, y = cell.y, z = cell.z; x > 0 || y > 0 || z > 0; x /= 3, y /= 3, z /= 3)
    if ((x % 3 == 1) + (y % 3 == 1) + (z % 3 == 1) >= 2)
      return 0;
  return voxc::rgba(230 - cell.x / 2, 120 + cell.y, 60 + cell.z);
}

std::uint32_t ringVoxel(voxc::Int3 cell) {
  const double x = cell.x - 63.5, y = cell.y - 63.5, z = cell.z - 7.5;
  const double around = std::hypot(x, y) - 56;
  if (std::hypot(around, z) > 7)
    return 0;
  const bool isStripe = (static_cast<int>(std::floor(std::atan2(y, x) * 12 / 3.14159265)) & 1) != 0;
  return isStripe ? voxc::rgba(70, 120, 190) : voxc::rgba(235, 235, 225);
}
