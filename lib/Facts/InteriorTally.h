// Counting voxels whose six face neighbours are there, in one pass over bricks in Morton order.
#pragma once

#include "Brick.h"

#include "voxc/Support/WorkingMemory.h"

#include <array>
#include <cstdint>
#include <memory>

namespace voxc {

/// A brick's lower neighbours come before it, its upper ones after: it waits, in a hash table, until the last
/// of these has come or been passed by. What has waited long enough is dropped whenever the table is full, so
/// that memory follows the border between the bricks that have come and those that have not.
class InteriorTally {
public:
  explicit InteriorTally(std::shared_ptr<WorkingMemory> memory)
      : memory_(std::move(memory)), table_(memory_) {}

  /// Takes the next brick that is not empty. Errors: as `WorkingMemory::allocate`.
  Expected<void> add(const Brick &brick);
  /// Ends the adding. Returns the number of interior voxels.
  std::uint64_t finish();

private:
  /// A brick whose upper neighbours have not all come.
  struct Waiting {
    std::uint64_t key;                  ///< Morton code of the brick, in bricks, plus 1; 0: free.
    Slices candidates;                  ///< Voxels whose neighbours, as far as they are known, are there.
    std::array<std::uint64_t, 3> faces; ///< Voxels on the upper face of each axis.
    std::uint32_t met;                  ///< A bit for each axis whose upper neighbour has come.
  };

  Waiting *find(std::uint64_t key);
  Expected<void> insert(const Waiting &brick);
  Expected<void> sweep(std::uint64_t now);
  void place(const Waiting &brick);
  void flush(Waiting brick);

  std::shared_ptr<WorkingMemory> memory_;
  ScratchArray<Waiting> table_;
  std::uint64_t used_ = 0;
  std::uint64_t interior_ = 0;
};

} // namespace voxc
