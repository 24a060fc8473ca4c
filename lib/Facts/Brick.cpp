// The bits of a brick.
#include "Brick.h"

namespace voxc {

bool Brick::findBits() {
  std::uint64_t any = 0;
  for (unsigned part = 0; part < 8; ++part) {
    std::uint64_t mask = 0;
    for (unsigned i = 0; i < 64; ++i)
      mask |= std::uint64_t{words[64 * part + i] != 0} << i;
    masks[part] = mask;
    any |= mask;
  }
  if (any == 0)
    return false;
  slices = {};
  for (unsigned i = 0; i < 64; ++i) {
    const std::uint64_t bits = octet(i);
    const Int3 cell = mortonCell(i) * 2;
    const auto shift = static_cast<unsigned>(cell.x + 8 * cell.y);
    const auto z = static_cast<unsigned>(cell.z);
    slices[z] |= ((bits & 3) | (bits >> 2 & 3) << 8) << shift;
    slices[z + 1] |= ((bits >> 4 & 3) | (bits >> 6 & 3) << 8) << shift;
  }
  return true;
}

} // namespace voxc
