// The container of NanoVDB grids: segments, each a head, an entry for each grid, and grids, compressed or
// not.
#pragma once

#include "Support/WatchedFile.h"
#include "voxc/Support/Progress.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace voxc {

/// A grid as a file lists it.
struct ListedGrid {
  std::string name;
  std::uint32_t type = 0;
  std::uint64_t bytes = 0; ///< In memory.
  std::uint16_t codec = 0;
  std::span<const std::byte> stored; ///< From its first byte in the file on, to the end of the file.
};

/// The bytes of a grid, in the file or inflated.
struct StoredGrid {
  std::span<const std::byte> bytes;
  std::shared_ptr<const void> storage; ///< Keeps them.
  std::string name;
  std::vector<std::string> others; ///< The other grids, as in "velocity (vectors of 3 floats)".
};

/// All grids of a file, those of its first segment first; or those that lie in memory order in a file without
/// a head. Errors: no NanoVDB, one of a version other than 32, or cut short.
Expected<std::vector<ListedGrid>> listNanoVdbGrids(std::span<const std::byte> bytes);

/// The grid of this name, or without one the first whose values can be a shape. Errors: as
/// `listNanoVdbGrids`; there is none, naming those there are; damaged.
Expected<StoredGrid> findNanoVdbGrid(std::shared_ptr<const WatchedFile> file, const std::string &name,
                                     const std::shared_ptr<WorkingMemory> &memory, const Progress &progress);

} // namespace voxc
