// Colours of the terrain: few and by voxel, so that patterns show up close and words repeat.
#include "Source/Builtin/TerrainColours.h"

#include "Source/Builtin/Scenes.h"

#include <algorithm>
#include <array>
#include <bit>

namespace voxc {

namespace {

using Palette = std::array<std::uint32_t, 4>;

constexpr Palette kGrass{rgba(92, 133, 58), rgba(104, 145, 64), rgba(117, 155, 72), rgba(134, 163, 80)};
constexpr Palette kMeadow{rgba(140, 160, 78), rgba(152, 166, 84), rgba(165, 171, 92), rgba(128, 152, 74)};
constexpr Palette kSand{rgba(222, 205, 158), rgba(214, 196, 148), rgba(229, 213, 168), rgba(207, 188, 140)};
constexpr Palette kRock{rgba(142, 136, 130), rgba(134, 128, 122), rgba(151, 145, 138), rgba(126, 120, 116)};
constexpr Palette kSnow{rgba(244, 247, 250), rgba(236, 241, 247), rgba(249, 251, 252), rgba(228, 235, 243)};
constexpr Palette kSoil{rgba(104, 76, 52), rgba(96, 70, 48), rgba(112, 82, 56), rgba(90, 65, 45)};
constexpr Palette kNeedles{rgba(40, 84, 48), rgba(46, 93, 52), rgba(53, 102, 56), rgba(35, 75, 45)};
constexpr std::uint32_t kTrunk = rgba(92, 66, 46);

constexpr std::array<std::uint32_t, 6> kStrata{rgba(148, 124, 98), rgba(128, 106, 88),  rgba(168, 143, 110),
                                               rgba(112, 98, 90),  rgba(182, 150, 112), rgba(139, 108, 84)};
constexpr std::array<std::uint32_t, 5> kWater{rgba(104, 176, 190), rgba(76, 152, 178), rgba(54, 126, 162),
                                              rgba(40, 104, 146), rgba(31, 86, 130)};

std::uint32_t pick(const Palette &palette, Int3 cell) { return palette[hashCell(cell, 3) % palette.size()]; }

int log2Below(int value) { return std::bit_width(static_cast<unsigned>(std::max(value, 1))) - 1; }

} // namespace

TerrainColours::TerrainColours(const TerrainShape &shape)
    : side_(shape.side()), waterLevel_(shape.waterLevel()), patches_(log2Below(side_ / 24), 41),
      folds_(log2Below(side_ / 4), 42) {}

std::uint32_t TerrainColours::ground(Int3 cell, int ground, int drop) const {
  const int depth = ground - cell.y;
  if (depth == 0)
    return cover(cell, drop);
  if (drop > 3)
    return cell.y > side_ * 2 / 5 ? pick(kRock, cell) : stratum(cell);
  return depth <= side_ / 100 + 1 ? pick(kSoil, cell) : stratum(cell);
}

std::uint32_t TerrainColours::cover(Int3 cell, int drop) const {
  const std::int64_t patch = patches_.over({cell.x, cell.z, cell.x, cell.z}).low;
  // Lines between kinds of cover waver by a twelfth of the side.
  const std::int64_t level = cell.y + (patch - kOne / 2) * side_ / 12 / kOne;
  if (cell.y <= waterLevel_ + side_ / 100)
    return pick(kSand, cell);
  if (level > side_ * 46 / 100)
    return drop > 5 ? pick(kRock, cell) : pick(kSnow, cell);
  if (drop > 2 || level > side_ * 40 / 100)
    return pick(kRock, cell);
  return pick(patch > kOne * 3 / 5 ? kMeadow : kGrass, cell);
}

std::uint32_t TerrainColours::stratum(Int3 cell) const {
  const std::int64_t fold = folds_.over({cell.x, cell.z, cell.x, cell.z}).low * side_ / 8 / kOne;
  const auto layer = static_cast<std::int32_t>((cell.y + fold) / std::max(side_ / 48, 1));
  return kStrata[hashCell({layer, 0, 0}, 5) % kStrata.size()];
}

std::uint32_t TerrainColours::water(Int3, int depth) const {
  const auto shade = static_cast<std::size_t>(std::int64_t{depth} * 40 / side_);
  return kWater[std::min(shade, kWater.size() - 1)];
}

std::uint32_t TerrainColours::tree(Int3 cell, const Tree &tree) const {
  const bool isTrunk =
      cell.x == tree.foot.x && cell.z == tree.foot.z && cell.y - tree.foot.y <= tree.height / 5;
  return isTrunk ? kTrunk : pick(kNeedles, cell);
}

} // namespace voxc
