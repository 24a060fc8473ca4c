// Blocks of voxels by their mean colours: found, and kept in a volume.
#include "voxc/Volume/CoarseBlocks.h"

#include "StreamTable.h"

#include <algorithm>
#include <array>

namespace voxc {
namespace {

constexpr int kBoxBits = 5;
constexpr std::uint32_t kBoxMask = (1u << kBoxBits) - 1;

/// Gathers the voxels of one block after the other, as Morton order has them.
class BlockGatherer {
public:
  explicit BlockGatherer(int log2Side) { found_.log2Side = log2Side; }

  /// False if there are too many.
  bool add(const Cube &cube, std::uint32_t word) {
    if (cube.log2Side >= found_.log2Side)
      return addWholeBlocks(cube, word);
    const std::uint64_t code = mortonCode(cube.low >> found_.log2Side);
    if (voxels_ > 0 && code != code_ && !flush())
      return false;
    code_ = code;
    addVoxels(cube, word);
    return true;
  }

  /// Those of the last block too.
  bool finish() { return voxels_ == 0 || flush(); }
  CoarseBlocks take() { return std::move(found_); }

private:
  bool addWholeBlocks(const Cube &cube, std::uint32_t word) {
    if (!finish())
      return false;
    const std::uint64_t count = std::uint64_t{1} << 3 * (cube.log2Side - found_.log2Side);
    if (count > kMostCoarseBlocks - found_.blocks.size())
      return false;
    const std::int32_t last = (1 << found_.log2Side) - 1;
    const std::uint64_t first = mortonCode(cube.low >> found_.log2Side);
    for (std::uint64_t i = 0; i < count; ++i)
      found_.blocks.push_back({first + i, word, packBox({{}, {last, last, last}})});
    return true;
  }

  void addVoxels(const Cube &cube, std::uint32_t word) {
    const std::uint64_t count = std::uint64_t{1} << 3 * cube.log2Side;
    const std::int32_t inside = (1 << found_.log2Side) - 1;
    for (int axis = 0; axis < 3; ++axis) {
      const std::int32_t low = cube.low[axis] & inside;
      const std::int32_t high = low + static_cast<std::int32_t>(cube.side()) - 1;
      box_.low[axis] = voxels_ == 0 ? low : std::min(box_.low[axis], low);
      box_.high[axis] = voxels_ == 0 ? high : std::max(box_.high[axis], high);
    }
    for (int channel = 0; channel < 4; ++channel)
      sums_[static_cast<std::size_t>(channel)] += count * (word >> 8 * channel & 0xff);
    voxels_ += count;
  }

  bool flush() {
    if (found_.blocks.size() == kMostCoarseBlocks)
      return false;
    std::uint32_t mean = 0;
    for (int channel = 0; channel < 4; ++channel)
      mean |= static_cast<std::uint32_t>((sums_[static_cast<std::size_t>(channel)] + voxels_ / 2) / voxels_)
              << 8 * channel;
    found_.blocks.push_back({code_, mean, packBox(box_)});
    sums_ = {};
    voxels_ = 0;
    return true;
  }

  CoarseBlocks found_;
  std::uint64_t code_ = 0; ///< Of the block that is gathered.
  std::uint64_t voxels_ = 0;
  std::array<std::uint64_t, 4> sums_{};
  CoarseBox box_;
};

/// What a volume with blocks lies in.
struct Kept {
  std::shared_ptr<const Volume> volume;
  std::vector<CoarseBlock> blocks;
};

} // namespace

std::uint32_t packBox(const CoarseBox &box) {
  std::uint32_t packed = 0;
  for (int axis = 0; axis < 3; ++axis)
    packed |= static_cast<std::uint32_t>(box.low[axis]) << kBoxBits * axis |
              static_cast<std::uint32_t>(box.high[axis]) << kBoxBits * (axis + 3);
  return packed;
}

CoarseBox unpackBox(std::uint32_t packed) {
  CoarseBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = static_cast<std::int32_t>(packed >> kBoxBits * axis & kBoxMask);
    box.high[axis] = static_cast<std::int32_t>(packed >> kBoxBits * (axis + 3) & kBoxMask);
  }
  return box;
}

Expected<CoarseBlocks> makeCoarseBlocks(const Volume &volume, int log2Side, const Progress &progress) {
  if (volume.layout().hasLabels())
    return Error::usage("the voxels of this volume are labels, which have no mean colour");
  BlockGatherer gatherer(log2Side);
  bool fits = true;
  const auto visit = [&](const Cube &cube, std::uint32_t word) { return fits = gatherer.add(cube, word); };
  VOXC_TRY(decode(volume, visit, progress));
  if (!fits || !gatherer.finish())
    return Error::usage("the volume has more than " + std::to_string(kMostCoarseBlocks) + " blocks of " +
                        std::to_string(1 << log2Side) + " voxels a side, the limit: take larger ones");
  return gatherer.take();
}

std::string coarseStreamName(int log2Side) { return "coarse-" + std::to_string(1 << log2Side); }

std::optional<int> coarseSideOf(std::string_view streamName) {
  for (int log2Side = kLeastLog2CoarseSide; log2Side <= kMostLog2CoarseSide; ++log2Side)
    if (streamName == coarseStreamName(log2Side))
      return log2Side;
  return std::nullopt;
}

Expected<Volume> withCoarseBlocks(std::shared_ptr<const Volume> volume, CoarseBlocks blocks) {
  std::vector<Stream> streams(volume->streams().begin(), volume->streams().end());
  std::erase_if(streams, [](const Stream &stream) { return coarseSideOf(stream.name).has_value(); });
  if (streams.size() == kMostStreams)
    return Error::usage("the volume has 63 attributes, and no room for coarse blocks; drop one first");
  VolumeInfo info = volume->info();
  const auto kept = std::make_shared<const Kept>(Kept{std::move(volume), std::move(blocks.blocks)});
  streams.push_back(
      {coarseStreamName(blocks.log2Side), sizeof(CoarseBlock), std::as_bytes(std::span(kept->blocks))});
  return Volume(std::move(info), std::move(streams), kept);
}

} // namespace voxc
