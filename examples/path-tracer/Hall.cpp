// Every voxel of the hall, by arithmetic.
#include "Hall.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>

namespace {

// As in path.comp.
constexpr std::uint32_t kStone = 255, kShining = 254, kMirror = 253;

std::uint32_t word(int r, int g, int b, std::uint32_t material = kStone) {
  const auto byte = [](int value) { return static_cast<std::uint32_t>(std::clamp(value, 0, 255)); };
  return byte(r) | byte(g) << 8 | byte(b) << 16 | material << 24;
}

/// A little that differs from voxel to voxel.
int grain(voxc::Int3 c) {
  std::uint32_t n = static_cast<std::uint32_t>(c.x * 73856093 ^ c.y * 19349663 ^ c.z * 83492791);
  n = (n ^ n >> 13) * 0x5bd1e995u;
  return static_cast<int>(n >> 28) - 8;
}

bool inSponge(int x, int y, int z) {
  for (; x > 0 || y > 0 || z > 0; x /= 3, y /= 3, z /= 3)
    if ((x % 3 == 1) + (y % 3 == 1) + (z % 3 == 1) >= 2)
      return false;
  return true;
}

bool inBall(voxc::Int3 c, voxc::Int3 centre, int radius) {
  const voxc::Int3 d{c.x - centre.x, c.y - centre.y, c.z - centre.z};
  return d.x * d.x + d.y * d.y + d.z * d.z <= radius * radius;
}

std::uint32_t floorVoxel(voxc::Int3 c) {
  const int dx = std::abs(c.x - 128), dz = std::abs(c.z - 150);
  if (std::max(dx, dz) < 66)
    return c.y < 2 ? word(120, 170, 185, kMirror) : 0;
  if (std::max(dx, dz) < 70)
    return c.y < 7 ? word(205 + grain(c), 195 + grain(c), 180 + grain(c)) : 0;
  const bool isDark = ((c.x / 16) ^ (c.z / 16)) & 1;
  const int light = (isDark ? 110 : 200) + grain(c) - (c.x % 16 == 0 || c.z % 16 == 0 ? 40 : 0);
  return c.y < 4 ? word(light, light * 9 / 10, light * 3 / 4) : 0;
}

std::uint32_t columnVoxel(voxc::Int3 c) {
  const int dx = std::abs(c.x - 128) < 100 ? std::abs(std::abs(c.x - 128) - 84) : 99;
  const int dz = std::abs((c.z + 3) % 42 - 21);
  const bool isSquare = c.y < 10 || c.y >= 90;
  if (isSquare)
    return std::max(dx, dz) <= 11 ? word(225 + grain(c), 210 + grain(c), 185 + grain(c)) : 0;
  const double angle = std::atan2(c.x < 128 ? c.x - 44 : c.x - 212, (c.z + 3) % 42 - 21);
  const double radius = 8.2 + 0.8 * std::cos(12 * angle) - 0.012 * (c.y - 10);
  return dx * dx + dz * dz <= radius * radius ? word(235 + grain(c), 222 + grain(c), 200 + grain(c)) : 0;
}

std::uint32_t wallVoxel(voxc::Int3 c) {
  if (c.x < 4)
    return word(190 + grain(c), 70 + grain(c), 50 + grain(c));
  if (c.x >= 252)
    return word(40 + grain(c), 130 + grain(c), 140 + grain(c));
  const int dx = c.x - 128, dy = c.y - 58;
  const bool isWindow = dx * dx + dy * dy < 34 * 34 && dx % 12 != 0 && dy % 12 != 0;
  return c.z >= 252 && !isWindow ? word(220 + grain(c), 205 + grain(c), 180 + grain(c)) : 0;
}

std::uint32_t roofVoxel(voxc::Int3 c) {
  const bool isAisle = std::abs(c.x - 128) > 66 && c.y < 106;
  const bool isBeam = std::abs((c.z + 3) % 42 - 21) < 4 && c.y < 104;
  return isAisle || isBeam ? word(150 + grain(c), 100 + grain(c), 60 + grain(c)) : 0;
}

std::uint32_t innerVoxel(voxc::Int3 c) {
  if (inBall(c, {128, 48, 150}, 9))
    return word(255, 180, 105, kShining);
  const voxc::Int3 s{c.x - 88, c.y - 8, c.z - 110};
  if (s.x >= 0 && s.y >= 0 && s.z >= 0 && std::max({s.x, s.y, s.z}) < 81 && inSponge(s.x, s.y, s.z))
    return word(240 + grain(c) / 2, 200 + grain(c) / 2, 120 + grain(c) / 2);
  if (inBall(c, {80, 18, 60}, 15))
    return word(235, 235, 240, kMirror);
  return inBall(c, {116, 15, 44}, 12) ? word(60, 90, 200) : 0;
}

} // namespace

std::uint32_t hallVoxel(voxc::Int3 cell) {
  using Part = std::uint32_t (*)(voxc::Int3);
  constexpr Part kLow[] = {floorVoxel, wallVoxel, columnVoxel, innerVoxel};
  constexpr Part kMiddle[] = {wallVoxel, columnVoxel, innerVoxel};
  constexpr Part kHigh[] = {roofVoxel, wallVoxel};
  const auto firstOf = [&](std::span<const Part> parts) {
    for (const Part part : parts)
      if (const std::uint32_t voxel = part(cell))
        return voxel;
    return 0u;
  };
  if (cell.y >= 112)
    return 0;
  return cell.y < 8 ? firstOf(kLow) : cell.y < 96 ? firstOf(kMiddle) : firstOf(kHigh);
}
