// Decoded voxels as runs of equal words in Morton order: the oracle's own picture of a volume.
#pragma once

#include "OccupancyTree.h"

#include "voxc/Support/Geometry.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace voxc {

/// log2 of the side of the smallest aligned cube at the origin that holds an extent.
int log2BoundingSide(Int3 extent);

/// The voxels of a volume of any extent up to 2^21 an axis. Empty space between voxels is a run of word 0, so
/// memory follows the voxels, not the extent, and a traversal skips empty cubes as large as an octree's.
class VoxelRuns {
public:
  explicit VoxelRuns(Int3 extent) : extent_(extent) {}

  /// Appends an aligned cube of one word, which may be 0; cubes come in Morton order and do not overlap.
  void add(const Cube &cube, std::uint32_t word);
  /// Ends the adding; needed before the first lookup.
  void finish();

  Int3 extent() const { return extent_; }
  /// Runs so far.
  std::size_t size() const { return words_.size(); }
  /// The word of a cell in the extent.
  std::uint32_t word(Int3 cell) const;
  /// The aligned empty cube around a cell in the extent that the tree of empty cells knows; nothing if the
  /// cell is not empty. The cube may reach beyond the extent, where all is empty.
  std::optional<Cube> emptyAround(Int3 cell) const;

  /// The first and the last cell of runs that are not empty, at most `count` cells, evenly spread over them.
  std::vector<Int3> sample(std::size_t count) const;

private:
  void startRun(std::uint64_t code, std::uint32_t word);
  std::vector<std::uint64_t> changes() const;
  void makeIndex(int codeBits);

  Int3 extent_;
  std::uint64_t end_ = 0;             // Morton code after the last cube.
  std::vector<std::uint64_t> starts_; // Morton code of each run's first cell; then that of no cell.
  std::vector<std::uint32_t> words_;  // One a run.
  std::vector<std::size_t> firstRun_; // By the code's high bits: the run there, to shorten the search.
  int indexShift_ = 0;
  OccupancyTree occupancy_;
};

} // namespace voxc
