// From Morton order to coordinates and back, by cubes of 2^3.
#include "Source/BrickBits.h"

#include <algorithm>

namespace voxc {

MortonBits bitsOf(const std::uint32_t *words) {
  // A byte for each word, which compilers make of many at a time; then the lowest bits of eight come together
  // by a multiplication.
  constexpr std::uint64_t kGather = 0x0102040810204080;
  std::array<std::uint8_t, 512> filled;
  for (unsigned i = 0; i < 512; ++i)
    filled[i] = words[i] != 0;
  MortonBits bits{};
  for (unsigned i = 0; i < 64; ++i) {
    std::uint64_t eight = 0;
    for (unsigned k = 0; k < 8; ++k)
      eight |= std::uint64_t{filled[8 * i + k]} << 8 * k;
    bits[i / 8] |= (eight * kGather >> 56) << i % 8 * 8;
  }
  return bits;
}

Slices toSlices(const MortonBits &bits) {
  Slices slices{};
  for (unsigned i = 0; i < 64; ++i) {
    const std::uint64_t octet = bits[i / 8] >> 8 * (i % 8);
    const Int3 cell = mortonCell(i) * 2;
    const auto shift = static_cast<unsigned>(cell.x + 8 * cell.y);
    const auto z = static_cast<unsigned>(cell.z);
    slices[z] |= ((octet & 3) | (octet >> 2 & 3) << 8) << shift;
    slices[z + 1] |= ((octet >> 4 & 3) | (octet >> 6 & 3) << 8) << shift;
  }
  return slices;
}

MortonBits toMorton(const Slices &slices) {
  MortonBits bits{};
  for (unsigned i = 0; i < 64; ++i) {
    const Int3 cell = mortonCell(i) * 2;
    const auto shift = static_cast<unsigned>(cell.x + 8 * cell.y);
    const auto z = static_cast<unsigned>(cell.z);
    const std::uint64_t low = slices[z] >> shift;
    const std::uint64_t high = slices[z + 1] >> shift;
    const std::uint64_t octet = (low & 3) | (low >> 8 & 3) << 2 | (high & 3) << 4 | (high >> 8 & 3) << 6;
    bits[i / 8] |= octet << 8 * (i % 8);
  }
  return bits;
}

Slices cellsBetween(Int3 low, Int3 high) {
  const auto upTo = [](int end) { return (1u << std::clamp(end, 0, 8)) - 1; };
  const std::uint64_t row = upTo(high.x) & ~upTo(low.x);
  std::uint64_t slice = 0;
  for (int y = std::max(low.y, 0); y < std::min(high.y, 8); ++y)
    slice |= row << 8 * y;
  Slices cells{};
  for (int z = std::max(low.z, 0); z < std::min(high.z, 8); ++z)
    cells[static_cast<std::size_t>(z)] = slice;
  return cells;
}

} // namespace voxc
