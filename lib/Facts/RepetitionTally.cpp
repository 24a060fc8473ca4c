// Digests of blocks from those of their children. Mirroring a block mirrors its children and swaps them.
#include "RepetitionTally.h"

#include <algorithm>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace voxc {

namespace {

/// Swaps groups of `width` bits with their neighbours; `low` has the bits of the lower ones.
constexpr std::uint64_t swapGroups(std::uint64_t bits, int width, std::uint64_t low) {
  return (bits & low) << width | (bits >> width & low);
}

/// Mirrors 4^3 bits in Morton order along an axis: the two bits of a coordinate there are flipped.
constexpr std::uint64_t mirror(std::uint64_t bits, int axis) {
  switch (axis) {
  case 0:
    return swapGroups(swapGroups(bits, 1, 0x5555555555555555), 8, 0x00ff00ff00ff00ff);
  case 1:
    return swapGroups(swapGroups(bits, 2, 0x3333333333333333), 16, 0x0000ffff0000ffff);
  default:
    return swapGroups(swapGroups(bits, 4, 0x0f0f0f0f0f0f0f0f), 32, 0x00000000ffffffff);
  }
}

/// A shape of 4^3 voxels, mirrored in all ways.
constexpr std::array<std::uint64_t, 8> allMirrored(std::uint64_t bits) {
  std::array<std::uint64_t, 8> shapes{bits};
  for (unsigned way = 1; way < 8; ++way) {
    const int axis = way & 1 ? 0 : way & 2 ? 1 : 2;
    shapes[way] = mirror(shapes[way & (way - 1)], axis);
  }
  return shapes;
}

/// The shape of 2^3 voxels, a byte, that stands for all its mirrored ones.
std::uint64_t anyOctet(std::uint64_t octet) {
  // As the lowest octet of a cube of 4^3 it moves to another one, of which the others are empty.
  std::uint64_t least = octet;
  for (unsigned way = 1; way < 8; ++way)
    least = std::min(least, allMirrored(octet)[way] >> 8 * way);
  return least;
}

template <typename Values> std::uint64_t digest(const Values &values) {
  return XXH3_64bits(values.data(), sizeof values);
}

} // namespace

std::uint64_t Digests::anyShape() const { return *std::ranges::min_element(shapes); }

RepetitionTally::RepetitionTally(std::size_t mostBlocks) : heights_(kHeights, Height(mostBlocks)) {}

void RepetitionTally::Height::add(const Digests &digests) {
  ++blocks;
  shapes.insert(digests.shapes[0]);
  mirrored.insert(digests.anyShape());
  coloured.insert(digests.colours);
}

/// Counts the cubes of 2^3 of the part of a brick that has 4^3. Returns the digest of its colours.
std::uint64_t RepetitionTally::ofOctets(const Brick &brick, unsigned part) {
  std::array<std::uint64_t, 8> colours{};
  for (unsigned i = 0; i < 8; ++i) {
    const unsigned octet = 8 * part + i;
    if (brick.octet(octet) == 0)
      continue;
    octets_.set(brick.octet(octet));
    colours[i] = XXH3_64bits(&brick.words[8 * octet], 8 * sizeof brick.words[0]);
    ++at(1).blocks;
    at(1).coloured.insert(colours[i]);
  }
  return digest(colours);
}

Digests RepetitionTally::ofBrick(const Brick &brick) {
  std::array<Digests, 8> parts{};
  for (unsigned part = 0; part < 8; ++part) {
    if (brick.masks[part] == 0)
      continue;
    parts[part] = {ofOctets(brick, part), allMirrored(brick.masks[part])};
    at(2).add(parts[part]);
  }
  return ofChildren(parts, Brick::kLog2Side);
}

Digests RepetitionTally::ofChildren(std::span<const Digests, 8> children, int height) {
  if (height > kHeights)
    return {};
  Digests result;
  std::array<std::uint64_t, 8> values{};
  for (unsigned child = 0; child < 8; ++child)
    values[child] = children[child].colours;
  result.colours = digest(values);
  for (unsigned way = 0; way < 8; ++way) {
    for (unsigned child = 0; child < 8; ++child)
      values[child] = children[child ^ way].shapes[way];
    result.shapes[way] = digest(values);
  }
  at(height).add(result);
  return result;
}

RepetitionFacts RepetitionTally::facts(int height) const {
  const Height &counted = heights_[static_cast<std::size_t>(height - 1)];
  RepetitionFacts facts{height, counted.blocks, counted.shapes.count(), counted.mirrored.count(),
                        counted.coloured.count()};
  if (height > 1)
    return facts;
  facts.shapes.count = octets_.count();
  std::bitset<256> mirrored;
  for (std::size_t octet = 0; octet < octets_.size(); ++octet)
    if (octets_[octet])
      mirrored.set(anyOctet(octet));
  facts.mirrored.count = mirrored.count();
  return facts;
}

} // namespace voxc
