// Blocks of voxels from files that anyone may have made.
#include "voxc/Volume/CoarseBlocks.h"

#include <algorithm>
#include <cstring>

namespace voxc {
namespace {

/// Takes blocks in the order of the file, and what is wrong with one before it is believed.
class CoarseReader {
public:
  CoarseReader(const VolumeInfo &info, int log2Side) : voxels_(info.voxels) {
    blocks_.log2Side = log2Side;
    const Int3 extent = info.format.extent();
    for (int axis = 0; axis < 3; ++axis)
      room_[axis] = std::max(extent[axis] >> log2Side, 1);
  }

  /// What is wrong with so many elements of this size, before any is read; or nothing.
  std::string problemOf(std::uint32_t elementBytes, std::uint64_t bytes) const {
    if (elementBytes != sizeof(CoarseBlock) || bytes % sizeof(CoarseBlock) != 0)
      return "has coarse blocks of " + std::to_string(elementBytes) + " bytes, not " +
             std::to_string(sizeof(CoarseBlock));
    const std::uint64_t count = bytes / sizeof(CoarseBlock);
    if (count > std::min(voxels_, kMostCoarseBlocks) || (count == 0) != (voxels_ == 0))
      return "has " + std::to_string(count) + " coarse blocks, which cannot be for " +
             std::to_string(voxels_) + " voxels";
    return {};
  }

  /// What is wrong with some of them, or nothing.
  std::string add(std::span<const CoarseBlock> blocks) {
    for (const CoarseBlock &block : blocks) {
      if (std::string problem = problemOf(block); !problem.empty())
        return "has a coarse block, number " + std::to_string(blocks_.blocks.size()) + ", " + problem;
      blocks_.blocks.push_back(block);
    }
    return {};
  }

  CoarseBlocks take() { return std::move(blocks_); }

private:
  std::string problemOf(const CoarseBlock &block) const {
    if (!blocks_.blocks.empty() && block.code <= blocks_.blocks.back().code)
      return "that does not come after the one before it";
    if (block.code >> 3 * kMaxLog2Extent != 0 || !contains(room_, mortonCell(block.code)))
      return "that lies outside of the format";
    const CoarseBox box = unpackBox(block.box);
    const std::int32_t side = 1 << blocks_.log2Side;
    for (int axis = 0; axis < 3; ++axis)
      if (box.low[axis] > box.high[axis] || box.high[axis] >= side || packBox(box) != block.box)
        return "whose voxels lie in no box within it";
    return {};
  }

  std::uint64_t voxels_;
  Int3 room_; ///< In blocks.
  CoarseBlocks blocks_;
};

/// Decodes the pages of one stream of a file.
Expected<CoarseBlocks> readStream(const PagedVolume &volume, std::size_t index, int log2Side) {
  const PagedStream &stream = volume.streams()[index];
  CoarseReader reader(volume.info(), log2Side);
  if (std::string problem = reader.problemOf(stream.elementBytes, stream.bytes); !problem.empty())
    return Error::input("the file " + problem);
  std::vector<CoarseBlock> page(stream.pageBytes / sizeof(CoarseBlock)); // Pages are whole elements.
  for (std::uint64_t i = 0; i < stream.pages(); ++i) {
    const auto room = std::as_writable_bytes(std::span(page)).first(stream.bytesOf(i));
    VOXC_TRY(volume.decode(index, i, room));
    if (std::string problem = reader.add(std::span(page).first(room.size() / sizeof(CoarseBlock)));
        !problem.empty())
      return Error::input("the file " + problem);
  }
  return reader.take();
}

} // namespace

Expected<std::optional<CoarseBlocks>> coarseBlocksOf(const Volume &volume) {
  for (const Stream &stream : volume.streams()) {
    const std::optional<int> log2Side = coarseSideOf(stream.name);
    if (!log2Side)
      continue;
    CoarseReader reader(volume.info(), *log2Side);
    std::string problem = reader.problemOf(stream.elementBytes, stream.bytes.size());
    if (problem.empty())
      problem = reader.add(stream.as<CoarseBlock>());
    if (!problem.empty())
      return Error::input("the volume " + problem);
    return std::optional(reader.take());
  }
  return std::optional<CoarseBlocks>();
}

Expected<CoarseBlocks> readCoarseBlocks(const PagedVolume &volume) {
  const auto streams = volume.streams();
  for (std::size_t i = 0; i < streams.size(); ++i)
    if (const std::optional<int> log2Side = coarseSideOf(streams[i].name))
      return readStream(volume, i, *log2Side);
  return Error::usage("this file has no coarse blocks that could stand in for pages; `voxc export --compress "
                      "--coarse 8` makes one that has");
}

} // namespace voxc
