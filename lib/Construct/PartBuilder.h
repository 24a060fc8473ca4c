// Building parts: which cubes there are, and one of them at a time.
#pragma once

#include "Fragment.h"

#include "voxc/Source/VoxelSource.h"

#include <memory>
#include <optional>
#include <vector>

namespace voxc {

/// The generated code, as functions.
struct ConstructCode {
  std::uint32_t (*whole)(const construct::Host *host);
  void (*part)(const construct::Host *host, int x, int y, int z, int log2Side);
};

/// How a volume is cut into parts: all aligned cubes of one size, numbered in Morton order.
struct PartGrid {
  int log2Side = 0;  ///< Of a part, in voxels.
  int log2Count = 0; ///< log2 of the parts along a side of the bounding cube.

  /// Parts about as large as the cubes in which the source makes voxels, if the format and the source are as
  /// large, and whole nodes or cells of the layout.
  static PartGrid of(const VoxelSource &source, const Layout &layout);
  /// The same for parts of about 2^log2Side voxels a side, of a volume of these voxels.
  static PartGrid of(Int3 extent, const Layout &layout, int log2Side);

  std::uint64_t count() const { return std::uint64_t{1} << (3 * log2Count); }
  std::uint64_t index(Int3 low) const { return mortonCode(low >> log2Side); }
  /// The parts of the fragment `fragment` of `fragments` (at most 2^32): [first, second).
  std::pair<std::uint64_t, std::uint64_t> range(std::uint64_t fragment, std::uint64_t fragments) const;
};

/// The parts [begin, end) that may hold voxels, in order.
class PartSequence {
public:
  PartSequence(VoxelSource &source, const PartGrid &grid, std::uint64_t begin, std::uint64_t end);

  std::optional<Int3> next();

private:
  bool isExcluded(const Cube &cube) const;

  VoxelSource &source_;
  PartGrid grid_;
  std::uint64_t begin_;
  std::uint64_t end_;
  std::vector<Cube> ahead_; ///< The next is the last.
};

/// Builds parts of one source, one after the other, in memory of its own.
class PartBuilder {
public:
  /// Error: no memory.
  static Expected<PartBuilder> create(std::unique_ptr<VoxelSource> source, const ConstructCode &code,
                                      const Format &format, const std::shared_ptr<WorkingMemory> &memory);

  /// The part whose corner is `low`. Errors: the source's, no memory, too many words.
  Expected<Fragment> build(Int3 low, int log2Side, const Progress &progress);

private:
  PartBuilder(std::unique_ptr<VoxelSource> source, const ConstructCode &code, VoxelFacts facts,
              std::unique_ptr<NodeStore> store)
      : source_(std::move(source)), code_(code), facts_(facts), store_(std::move(store)) {}

  std::unique_ptr<VoxelSource> source_;
  ConstructCode code_;
  VoxelFacts facts_;
  std::unique_ptr<NodeStore> store_;
};

} // namespace voxc
