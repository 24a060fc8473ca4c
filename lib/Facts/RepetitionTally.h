// Counting blocks that differ, at several heights, by digests that are made of digests.
#pragma once

#include "Brick.h"
#include "DistinctSet.h"

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace voxc {

/// What blocks of one height are compared by; 0 for an empty block.
struct Digests {
  std::uint64_t colours = 0;
  /// Of the shape, mirrored in x if bit 0 of the index is set, in y for bit 1 and in z for bit 2. Up to 4^3
  /// voxels these are the voxels' bits themselves.
  std::array<std::uint64_t, 8> shapes{};

  /// Of the shape, whichever way it is mirrored.
  std::uint64_t anyShape() const;
};

class RepetitionTally {
public:
  static constexpr int kHeights = 6; ///< Of the largest blocks that are counted.

  /// Keeps `mostBlocks` different blocks of each kind and height at most.
  explicit RepetitionTally(std::size_t mostBlocks);

  /// Counts a brick that is not empty and the blocks of which it is made. Returns its digests.
  Digests ofBrick(const Brick &brick);
  /// Counts a block of this height, 4 or more, that is not empty; `children` are in Morton order. Returns its
  /// digests, or nothing above `kHeights`.
  Digests ofChildren(std::span<const Digests, 8> children, int height);

  /// The facts of one height, 1 to `kHeights`.
  RepetitionFacts facts(int height) const;

private:
  struct Height {
    explicit Height(std::size_t most) : shapes(most), mirrored(most), coloured(most) {}
    void add(const Digests &digests);

    std::uint64_t blocks = 0;
    DistinctSet shapes, mirrored, coloured;
  };

  std::uint64_t ofOctets(const Brick &brick, unsigned part);
  Height &at(int height) { return heights_[static_cast<std::size_t>(height - 1)]; }

  std::vector<Height> heights_; ///< From height 1 on.
  std::bitset<256> octets_;     ///< Shapes of 2^3 voxels that were seen: there are so few.
};

} // namespace voxc
