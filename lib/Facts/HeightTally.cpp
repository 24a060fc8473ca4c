// Cubes from their eight children, from single voxels up.
#include "HeightTally.h"

#include <bit>

namespace voxc {

void HeightTally::add(const Filling &cube, int height) {
  if (cube.voxels == 0)
    return;
  HeightFacts &facts = heights_[static_cast<std::size_t>(height)];
  // 2^63 cells at most.
  const bool isFull = cube.voxels == std::uint64_t{1} << 3 * height;
  ++facts.occupied;
  facts.full += isFull;
  facts.oneColour += cube.tone.isOne();
  facts.uniform += isFull && cube.tone.isOne();
}

Filling HeightTally::ofBrick(const Brick &brick) {
  std::array<Filling, 8> parts;
  std::array<Filling, 8> octets;
  for (unsigned part = 0; part < 8; ++part) {
    for (unsigned i = 0; i < 8; ++i) {
      const unsigned octet = 8 * part + i;
      octets[i] = {};
      if (brick.octet(octet) == 0)
        continue;
      octets[i].voxels = static_cast<std::uint64_t>(std::popcount(brick.octet(octet)));
      for (unsigned voxel = 0; voxel < 8; ++voxel)
        octets[i].tone = octets[i].tone | Tone(brick.words[8 * octet + voxel]);
      add(octets[i], 1);
    }
    parts[part] = ofChildren(octets, 2);
  }
  const Filling whole = ofChildren(parts, Brick::kLog2Side);
  // A voxel is full, and of one colour.
  HeightFacts &voxels = heights_[0];
  voxels.occupied += whole.voxels;
  voxels.full = voxels.oneColour = voxels.uniform = voxels.occupied;
  return whole;
}

Filling HeightTally::ofChildren(std::span<const Filling, 8> children, int height) {
  Filling cube;
  for (const Filling &child : children) {
    cube.voxels += child.voxels;
    cube.tone = cube.tone | child.tone;
  }
  add(cube, height);
  return cube;
}

} // namespace voxc
