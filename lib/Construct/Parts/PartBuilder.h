// Building parts: which cubes there are, and one of them at a time.
#pragma once

#include "Construct/Host/ConstructCode.h"
#include "Fragment.h"

#include "voxc/Source/VoxelSource.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace voxc {

/// How a volume is cut into parts: aligned cubes. Those of the smallest size are numbered in Morton order; a
/// larger one stands for all that it covers.
struct PartGrid {
  int log2Side = 0;         ///< Of the smallest parts, in voxels.
  int log2Count = 0;        ///< log2 of the smallest parts along a side of the bounding cube.
  std::uint32_t larger = 0; ///< Bit k: parts may have 2^k voxels a side too.

  /// Parts about as large as the cubes in which the source makes voxels, if the format and the source are as
  /// large, and whole nodes or cells of the layout.
  static PartGrid of(const VoxelSource &source, const Layout &layout);
  /// The same for parts of about 2^log2Side voxels a side, of a volume of these voxels.
  static PartGrid of(Int3 extent, const Layout &layout, int log2Side);
  /// The same with larger parts of up to 2^log2Largest voxels a side, as far as the layout allows them.
  PartGrid upTo(int log2Largest, const Layout &layout) const;

  std::uint64_t count() const { return std::uint64_t{1} << (3 * log2Count); }
  std::uint64_t index(Int3 low) const { return mortonCode(low >> log2Side); }
  bool allows(int log2Part) const { return log2Part == log2Side || (larger >> log2Part & 1) != 0; }
  /// The parts of the fragment `fragment` of `fragments` (at most 2^32): [first, second).
  std::pair<std::uint64_t, std::uint64_t> range(std::uint64_t fragment, std::uint64_t fragments) const;
};

/// The largest parts that cover the smallest ones [begin, end) and hold anything, in order.
class PartSequence {
public:
  using Test = std::function<bool(const Cube &)>;

  /// `isEmpty`: true only of a cube that is known to hold nothing. `isTooLarge`: of one that shall be cut
  /// further, if it can be; null: of none. Both are asked for cubes whose Morton codes never fall.
  PartSequence(const PartGrid &grid, std::uint64_t begin, std::uint64_t end, Test isEmpty,
               Test isTooLarge = {});

  std::optional<Cube> next();

  /// How many of the smallest parts were given, as they are or in larger ones, or found to be empty: all of
  /// [begin, end) at the end.
  std::uint64_t looked() const { return looked_; }

private:
  bool isPart(const Cube &cube) const;
  std::uint64_t countOf(const Cube &cube) const;
  std::uint64_t countInRange(const Cube &cube) const;

  PartGrid grid_;
  std::uint64_t begin_;
  std::uint64_t end_;
  Test isEmpty_;
  Test isTooLarge_;
  std::vector<Cube> ahead_; ///< The next is the last.
  std::uint64_t looked_ = 0;
};

/// Copies what a store has come to into a fragment.
void keepWords(NodeStore &store, Fragment &fragment);

/// Builds parts of one source, one after the other, in memory of its own.
class PartBuilder {
public:
  /// `layout`: of the volume. `isEdited`: the source is what edits would make. Error: no memory.
  static Expected<PartBuilder> create(std::unique_ptr<VoxelSource> source, const ConstructCode &code,
                                      const Layout &layout, const std::shared_ptr<WorkingMemory> &memory,
                                      bool isEdited = false);

  /// One part. Errors: the source's, no memory, too many words.
  Expected<Fragment> build(const Cube &cube, const Progress &progress);

private:
  PartBuilder(std::unique_ptr<VoxelSource> source, const ConstructCode &code, VoxelFacts facts,
              std::unique_ptr<NodeStore> store, bool isEdited)
      : source_(std::move(source)), code_(code), facts_(facts), store_(std::move(store)),
        isEdited_(isEdited) {}

  std::unique_ptr<VoxelSource> source_;
  ConstructCode code_;
  VoxelFacts facts_;
  std::unique_ptr<NodeStore> store_;
  bool isEdited_;
};

} // namespace voxc
