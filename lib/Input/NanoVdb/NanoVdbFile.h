// The container of NanoVDB grids: a file's head, an entry for each grid, and grids, compressed or not.
#pragma once

#include "Support/WatchedFile.h"
#include "voxc/Support/Progress.h"

#include <memory>
#include <span>

namespace voxc {

/// The bytes of a grid, in the file or inflated.
struct StoredGrid {
  std::span<const std::byte> bytes;
  std::shared_ptr<const void> storage; ///< Keeps them.
  std::uint32_t others = 0;            ///< Grids that follow it.
};

/// The first grid of a file, or a grid that is all of it. Errors: no NanoVDB, one of a version other than 32,
/// compressed by Blosc, or cut short.
Expected<StoredGrid> findNanoVdbGrid(std::shared_ptr<const WatchedFile> file,
                                     const std::shared_ptr<WorkingMemory> &memory, const Progress &progress);

} // namespace voxc
