// Distances in the cells of sub-volumes, as construction measures them, made where rays come by.
#pragma once

#include "voxc/Layout/Stratum.h"
#include "voxc/Search/SceneDag.h"

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

namespace voxc {

class DistanceFields {
public:
  explicit DistanceFields(const SceneDag &dag) : dag_(dag) {}

  /// One sub-volume of a stratum that has distances: a cube of 2^top voxels a side, by its number.
  struct SubVolume {
    const Stratum &stratum;
    int top;
    std::size_t number;
    bool isWhole; ///< Nothing is beyond it.
  };

  /// What the empty cell at a place, counted in cells of the sub-volume, says of the cells around it, for a
  /// ray of this octant (a bit for each coordinate that rises, x lowest): an L1 distance, or the side of a
  /// cube.
  int at(const SubVolume &in, Int3 cell, unsigned octant);

private:
  /// Cells, x fastest.
  using Field = std::vector<std::uint8_t>;
  using Key = std::tuple<int, int, std::size_t, unsigned, std::uint32_t>;

  Field occupancyOf(const SubVolume &in) const;
  Field measure(const SubVolume &in, unsigned octant) const;

  const SceneDag &dag_;
  std::map<Key, Field> fields_; ///< By bottom, top, number, octant (8: L1) and reach.
};

} // namespace voxc
