// The shape of the terrain: the height of the ground at every place, the water's level, and where trees
// stand.
#pragma once

#include "Source/Builtin/Noise.h"

#include "voxc/Support/Geometry.h"

#include <optional>
#include <vector>

namespace voxc {

/// A conifer. Trees stand in the middle of square tiles of the plane and do not reach over them.
struct Tree {
  Int3 foot;
  int height;
  int radius;

  /// True if `cell` is in its trunk or its crown, which narrows upward in whorls.
  bool holds(Int3 cell) const;
};

class TerrainShape {
public:
  explicit TerrainShape(int side);

  int side() const { return side_; }
  int waterLevel() const { return waterLevel_; }
  /// The height of the uppermost voxel of the ground, from 0 to side - 1.
  int ground(int x, int z) const { return static_cast<int>(groundOver({x, z, x, z}).low); }
  /// Bounds of the ground over an area.
  Range groundOver(const Rectangle &area) const;

  /// log2 of a tile's side; every tree is lower than a tile is wide.
  int log2Tile() const { return log2Tile_; }
  /// The tree of a tile, if one stands there.
  std::optional<Tree> tree(int tileX, int tileZ) const;

private:
  struct Octave {
    Noise noise;
    std::int64_t weight;
  };

  static Range sum(const std::vector<Octave> &octaves, const Rectangle &area, bool ridges);

  int side_;
  int waterLevel_;
  int log2Tile_;
  std::vector<Octave> land_; ///< Where it is high and where low.
  std::vector<Octave> hills_;
  std::vector<Octave> mountains_; ///< Summed up as ridges.
  Noise forest_;
};

} // namespace voxc
