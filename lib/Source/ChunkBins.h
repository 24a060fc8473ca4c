// Records sorted into the chunks of a volume, by counting: what meshes and points keep until they are asked.
#pragma once

#include "voxc/Support/Geometry.h"
#include "voxc/Support/WorkingMemory.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

namespace voxc {

/// Bins of records, one for each aligned cube of 2^log2Chunk voxels a side. Whoever fills them goes twice
/// through the same records in the same order: first `count` for each, then, after `allocate`, `place`. A bin
/// keeps the order in which its records came. Bins lie in Morton order, so the records of an aligned cube of
/// chunks follow one another. After the last `place` all readers may run in several threads.
template <typename Record> class ChunkBins {
public:
  /// At most 2^kLog2Grid chunks an axis.
  static constexpr int kLog2Grid = 7;

  /// log2 of the side of the smallest chunks, of at least 2^smallest voxels, that are few enough.
  static int log2ChunkFor(Int3 extent, int smallest, int log2Grid = kLog2Grid) {
    const int last = std::max({extent.x, extent.y, extent.z}) - 1;
    int log2Chunk = smallest;
    while (last >> log2Chunk >> log2Grid != 0)
      ++log2Chunk;
    return log2Chunk;
  }

  /// Empty bins for the voxels in [0, extent). Errors: as `WorkingMemory::allocate`.
  static Expected<ChunkBins> create(Int3 extent, int log2Chunk,
                                    const std::shared_ptr<WorkingMemory> &memory) {
    ChunkBins bins(log2Chunk, memory);
    const Int3 last = (extent - Int3{1, 1, 1}) >> log2Chunk;
    VOXC_TRY(bins.ends_.resize(mortonCode(last) + 1));
    return bins;
  }

  int log2Chunk() const { return log2Chunk_; }
  /// All records in all bins.
  std::uint64_t size() const { return ends_[ends_.size() - 1]; }

  /// Says that one record will come to `chunk`, given in chunks.
  void count(Int3 chunk) { ++ends_[mortonCode(chunk)]; }

  /// Makes room for what was counted.
  Expected<void> allocate() {
    std::uint64_t begin = 0;
    for (std::uint64_t &end : ends_.span())
      begin += std::exchange(end, begin);
    return records_.resize(begin);
  }

  /// Adds one of the counted records. Until the last one is placed, `ends_` holds where each bin goes on.
  void place(Int3 chunk, const Record &record) { records_[ends_[mortonCode(chunk)]++] = record; }

  /// The records of a chunk.
  std::span<const Record> at(Int3 chunk) const {
    const std::uint64_t code = mortonCode(chunk);
    const std::uint64_t begin = endBefore(code);
    return records_.span().subspan(begin, endBefore(code + 1) - begin);
  }

  /// The records in `cube`, which is aligned and no smaller than a chunk.
  std::uint64_t sizeOf(const Cube &cube) const {
    const std::uint64_t code = mortonCode(cube.low >> log2Chunk_);
    const std::uint64_t count = std::uint64_t{1} << 3 * (cube.log2Side - log2Chunk_);
    return endBefore(code + count) - endBefore(code);
  }

  /// True if no record lies in such a cube.
  bool empty(const Cube &cube) const { return sizeOf(cube) == 0; }

private:
  ChunkBins(int log2Chunk, const std::shared_ptr<WorkingMemory> &memory)
      : log2Chunk_(log2Chunk), ends_(memory), records_(memory) {}

  /// How many records lie in the bins before the one at `code`, which may lie behind all bins.
  std::uint64_t endBefore(std::uint64_t code) const {
    return code == 0 ? 0 : ends_[std::min(code, ends_.size()) - 1];
  }

  int log2Chunk_;
  ScratchArray<std::uint64_t> ends_; ///< Where each bin ends in `records_`.
  ScratchArray<Record> records_;
};

} // namespace voxc
