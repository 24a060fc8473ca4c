// Heights of the terrain as sums of noise, in fractions of the side.
#include "Source/Builtin/TerrainShape.h"

#include "Source/Builtin/Scenes.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace voxc {

namespace {

constexpr std::uint32_t kSeed = 11;

constexpr std::int64_t percent(std::int64_t p) { return p * kOne / 100; }

Range scale(Range range, std::int64_t factor) { return multiply(range, {factor, factor}); }

/// The logarithm of the smallest power of two that is not below `side`.
int log2Above(int side) { return static_cast<int>(std::bit_width(static_cast<unsigned>(side - 1))); }

} // namespace

bool Tree::holds(Int3 cell) const {
  const Int3 offset = cell - foot;
  if (offset.y <= 0 || offset.y > height)
    return false;
  const int squared = offset.x * offset.x + offset.z * offset.z;
  if (squared == 0)
    return true;
  const int bare = height / 5;
  if (offset.y <= bare)
    return false;
  // Every third layer sticks out.
  const int reach = (radius * 2 * (height - offset.y + 1)) / (height - bare) - (offset.y % 3 != 0);
  return 4 * squared <= reach * reach;
}

TerrainShape::TerrainShape(int side)
    : side_(side), waterLevel_(static_cast<int>(std::int64_t{side} * 20 / 100)),
      log2Tile_(side >= 512 ? 4 : 3), forest_(std::max(log2Above(side) - 3, 0), 99) {
  const int log2Side = log2Above(side);
  const auto add = [&](std::vector<Octave> &octaves, int largest, int smallest, std::int64_t weight) {
    for (int log2Square = log2Side - largest; log2Square >= smallest; --log2Square, weight /= 2) {
      const auto seed = kSeed + static_cast<std::uint32_t>(16 * octaves.size() + 1000 * largest);
      octaves.push_back({Noise(std::max(log2Square, 0), seed), weight});
    }
  };
  add(land_, 1, std::max(log2Side - 3, 0), percent(58));
  add(hills_, 4, 2, percent(50));
  add(mountains_, 2, 2, percent(50));
}

Range TerrainShape::sum(const std::vector<Octave> &octaves, const Rectangle &area, bool ridges) {
  Range total{0, 0};
  for (const Octave &octave : octaves) {
    const Range value = octave.noise.over(area);
    total = total + scale(ridges ? ridge(value) : value, octave.weight);
  }
  return total;
}

Range TerrainShape::groundOver(const Rectangle &area) const {
  const Range land = sum(land_, area, false);
  Range height =
      Range{percent(4), percent(4)} + scale(land, percent(30)) + scale(sum(hills_, area, false), percent(5));
  const Range mountainous = ramp(land, percent(44), percent(92));
  if (mountainous.high > 0) {
    const Range ridges = sum(mountains_, area, true);
    height = height + scale(multiply(mountainous, multiply(ridges, ridges)), percent(85));
  }
  const auto voxels = [&](std::int64_t fraction) {
    return std::clamp<std::int64_t>(fraction * side_ >> 16, 0, side_ - 1);
  };
  return {voxels(height.low), voxels(height.high)};
}

std::optional<Tree> TerrainShape::tree(int tileX, int tileZ) const {
  constexpr int kSmallestForest = 64;
  const std::uint32_t hash = hashCell({tileX, tileZ, 0}, kSeed);
  const int tile = 1 << log2Tile_;
  const int radius = tile / 4;
  const auto within = [&](std::uint32_t bits) {
    return radius + static_cast<int>(bits) % (tile - 2 * radius);
  };
  Int3 foot{(tileX << log2Tile_) + within(hash & 255), 0, (tileZ << log2Tile_) + within(hash >> 8 & 255)};
  if (side_ < kSmallestForest || foot.x + radius >= side_ - 1 || foot.z + radius >= side_ - 1)
    return std::nullopt;
  const std::int64_t forest = forest_.over({foot.x, foot.z, foot.x, foot.z}).low;
  if (static_cast<std::int64_t>(hash >> 16) > ramp({forest, forest}, percent(25), percent(70)).low)
    return std::nullopt;
  foot.y = ground(foot.x, foot.z);
  const int steepness =
      std::abs(ground(foot.x + 1, foot.z) - foot.y) + std::abs(ground(foot.x, foot.z + 1) - foot.y);
  const bool isFertile = foot.y > waterLevel_ + side_ / 64 && foot.y < std::int64_t{side_} * 45 / 100;
  if (!isFertile || steepness > 3)
    return std::nullopt;
  return Tree{foot, tile / 2 + static_cast<int>(hash >> 24) % (tile / 2), radius};
}

} // namespace voxc
