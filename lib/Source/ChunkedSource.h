// A source that makes its voxels chunk by chunk from lists.
#pragma once

#include "voxc/Source/Sources.h"

#include <memory>
#include <span>

namespace voxc {

/// Lists of voxels, one for each chunk of 64 voxels a side (`ChunkBricks::kLog2Chunk`), for one reader.
class ChunkLists {
public:
  virtual ~ChunkLists() = default;
  /// True if it is known that no voxel lies in `cube`, which is aligned, no smaller than a chunk, and reaches
  /// into the extent.
  virtual bool empty(const Cube &cube) = 0;
  /// The voxels of a chunk, given in chunks, in any order; the first of several with one code counts. They
  /// stay until the next call. Errors: the list could not be made.
  virtual Expected<std::span<const CodedVoxel>> voxels(Int3 chunk) = 0;
  /// The same lists for another reader; null if there can be but one.
  virtual std::unique_ptr<ChunkLists> view() const = 0;
};

std::unique_ptr<VoxelSource> makeChunkedSource(Int3 extent, std::unique_ptr<ChunkLists> lists,
                                               const Transform &voxelToModel);

} // namespace voxc
