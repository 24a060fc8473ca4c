// Integer geometry of voxel space: cell coordinates, extents, aligned cubes and Morton order.
#pragma once

#include <cstdint>

namespace voxc {

/// A cell's coordinates, or an extent in cells, along x, y and z.
struct Int3 {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t z = 0;

  bool operator==(const Int3 &) const = default;
  std::int32_t operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  std::int32_t &operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }

  friend Int3 operator+(Int3 a, Int3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Int3 operator-(Int3 a, Int3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Int3 operator*(Int3 a, std::int32_t s) { return {a.x * s, a.y * s, a.z * s}; }
  friend Int3 operator>>(Int3 a, int s) { return {a.x >> s, a.y >> s, a.z >> s}; }
};

/// True if `cell` lies in [0, extent) on every axis.
inline bool contains(Int3 extent, Int3 cell) {
  return cell.x >= 0 && cell.y >= 0 && cell.z >= 0 && cell.x < extent.x && cell.y < extent.y &&
         cell.z < extent.z;
}

/// The cube [low, low + 2^log2Side)^3; aligned: each coordinate of `low` is a multiple of 2^log2Side.
struct Cube {
  Int3 low;
  int log2Side = 0;

  std::int64_t side() const { return std::int64_t{1} << log2Side; }
};

/// Largest number of cells on an axis: 2^kMaxLog2Extent, which a 64-bit Morton code has room for.
inline constexpr int kMaxLog2Extent = 21;

/// Spreads the low 21 bits of `value` to every third bit.
constexpr std::uint64_t spreadBits(std::uint64_t value) {
  value &= 0x1fffff;
  value = (value | value << 32) & 0x001f00000000ffff;
  value = (value | value << 16) & 0x001f0000ff0000ff;
  value = (value | value << 8) & 0x100f00f00f00f00f;
  value = (value | value << 4) & 0x10c30c30c30c30c3;
  return (value | value << 2) & 0x1249249249249249;
}

/// Gathers every third bit of `code`: the inverse of `spreadBits`.
constexpr std::uint32_t gatherBits(std::uint64_t code) {
  code &= 0x1249249249249249;
  code = (code ^ code >> 2) & 0x10c30c30c30c30c3;
  code = (code ^ code >> 4) & 0x100f00f00f00f00f;
  code = (code ^ code >> 8) & 0x001f0000ff0000ff;
  code = (code ^ code >> 16) & 0x001f00000000ffff;
  return static_cast<std::uint32_t>((code ^ code >> 32) & 0x1fffff);
}

/// Position in Morton order (x in bit 0, y in bit 1, z in bit 2) of a cell with coordinates in [0, 2^21).
constexpr std::uint64_t mortonCode(Int3 cell) {
  return spreadBits(static_cast<std::uint32_t>(cell.x)) |
         spreadBits(static_cast<std::uint32_t>(cell.y)) << 1 |
         spreadBits(static_cast<std::uint32_t>(cell.z)) << 2;
}

/// The cell at a position in Morton order.
constexpr Int3 mortonCell(std::uint64_t code) {
  return {static_cast<std::int32_t>(gatherBits(code)), static_cast<std::int32_t>(gatherBits(code >> 1)),
          static_cast<std::int32_t>(gatherBits(code >> 2))};
}

} // namespace voxc
